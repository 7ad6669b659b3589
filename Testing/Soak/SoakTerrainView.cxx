// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A session of terrain-view on an X server of its own: random keys, drags, sizes and files.
//   SoakTerrainView PROGRAM FOLDER MINUTES SEED       FOLDER has the files of files.py
// The seed decides all but the number of steps. A line a step on standard output; `rest N W` is the
// viewer's resident memory in kB while it shows a small terrain, in the window of number W. What
// the viewer says on standard error is a finding.
#include "VirtualDisplay.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <random>
#include <ratio>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace
{
constexpr int kWidth = 240;
constexpr int kHeight = 160;
constexpr int kStepsBetweenRests = 12;
constexpr int kTries = 5; // of a minute each
constexpr std::array<const char*, 4> kFiles{ "small.img", "middle.img", "prepared.hierarchy",
  "large.img" };
/// All keys of the viewer but q; those of a large file do without the others' techniques.
constexpr const char* kKeys = "tT+-ciluwxornmpysSh";
constexpr const char* kKeysOfTiles = "+-ciluxornmpyh";

class Session
{
public:
  Session(std::string folder, unsigned int seed)
    : Folder(std::move(folder))
    , Random(seed)
  {
  }

  /// Starts the viewer with a small terrain; false if there is no window.
  bool Open(const std::string& program)
  {
    const std::vector<std::string> command{ program, this->Folder + "/small.img", "--width",
      std::to_string(kWidth), "--height", std::to_string(kHeight) };
    return this->Screen.IsThere() &&
      (this->Screen.Start(command, this->Folder, this->Folder + "/view.printed", "terrain-view") ||
        this->Wait([&] { return this->Screen.Find("terrain-view"); }));
  }

  /// Shows a file of the folder other than that which is shown (a window is known by its title);
  /// false if it does not appear.
  bool Show(const std::string& file)
  {
    this->Shown = file;
    ++this->Windows;
    return this->Wait([&] { return this->Screen.WaitForRest(); }) &&
      this->Screen.Drop(this->Folder + "/" + file) &&
      this->Wait([&] { return this->Screen.Find(file); });
  }

  /// One thing that a user may do; false if the viewer does not answer.
  bool Step()
  {
    const int what = this->Choose(20);
    const int x = this->Choose(this->Width);
    const int y = this->Choose(this->Height);
    if (what == 0)
    {
      return this->Show(this->PrintedFile());
    }
    if (what < 3)
    {
      this->Resize(64 + this->Choose(400), 64 + this->Choose(300));
    }
    else if (what < 6)
    {
      this->Drag(1 + static_cast<unsigned int>(this->Choose(3)), x, y);
    }
    else if (what < 10)
    {
      this->Turn(4 + static_cast<unsigned int>(this->Choose(2)), x, y);
    }
    else
    {
      const std::string keys = this->Shown == kFiles[3] ? kKeysOfTiles : kKeys;
      const char key = keys[static_cast<std::size_t>(this->Choose(static_cast<int>(keys.size())))];
      std::cout << " key " << key << std::flush;
      this->Screen.Type(key, x, y);
    }
    return this->Wait([&] { return this->Screen.WaitForRest(); });
  }

  /// The viewer's resident memory in kB while it shows a small terrain; 0 if it is gone.
  long Rest()
  {
    this->Resize(kWidth, kHeight);
    if ((this->Shown == kFiles[0] && !this->Show(kFiles[1])) || !this->Show(kFiles[0]) ||
      !this->Wait([&] { return this->Screen.WaitForRest(); }))
    {
      return 0;
    }
    long pages = 0;
    std::ifstream("/proc/" + std::to_string(this->Screen.GetProgram()) + "/statm") >> pages >>
      pages;
    return pages * (sysconf(_SC_PAGESIZE) / 1024);
  }

  /// Windows that the viewer has opened: one a file.
  int GetWindows() const
  {
    return this->Windows;
  }

  int Quit()
  {
    this->Screen.Type('q', 1, 1);
    return this->Screen.WaitForExit();
  }

private:
  /// Waits several times as long as a test does, for a machine that has other things to do.
  bool Wait(const std::function<bool()>& condition) const
  {
    for (int k = 0; k < kTries; ++k)
    {
      if (condition())
      {
        return true;
      }
      if (kill(this->Screen.GetProgram(), 0) != 0)
      {
        return false;
      }
    }
    return false;
  }

  int Choose(int count)
  {
    // not a distribution of the library, whose numbers differ between libraries
    return static_cast<int>(this->Random() % static_cast<unsigned int>(count));
  }

  std::string PrintedFile()
  {
    std::string file = this->Shown;
    while (file == this->Shown)
    {
      file = kFiles[static_cast<std::size_t>(this->Choose(4))];
    }
    std::cout << " file " << file << std::flush;
    return file;
  }

  void Resize(int width, int height)
  {
    std::cout << " size " << width << 'x' << height << std::flush;
    this->Width = width;
    this->Height = height;
    this->Screen.Resize(width, height);
  }

  void Drag(unsigned int button, int x, int y)
  {
    std::cout << " drag " << button << std::flush;
    this->Screen.Press(button, x, y);
    for (int move = 0; move < 3; ++move)
    {
      this->Screen.Move(this->Choose(this->Width), this->Choose(this->Height));
    }
    this->Screen.Release(button, this->Choose(this->Width), this->Choose(this->Height));
  }

  void Turn(unsigned int button, int x, int y)
  {
    std::cout << " wheel " << button << std::flush;
    this->Screen.Press(button, x, y);
    this->Screen.Release(button, x, y);
  }

  std::string Folder;
  std::mt19937 Random;
  VirtualDisplay Screen;
  int Width = kWidth;
  int Height = kHeight;
  std::string Shown = kFiles[0];
  int Windows = 1;
};
}

int main(int argc, char* argv[])
{
  if (argc != 5)
  {
    std::cerr << "SoakTerrainView PROGRAM FOLDER MINUTES SEED\n";
    return 2;
  }
  Session session(argv[2], static_cast<unsigned int>(std::strtoul(argv[4], nullptr, 10)));
  if (!session.Open(argv[1]))
  {
    std::cerr << "terrain-view does not show a window (is Xvfb there?)\n";
    return EXIT_FAILURE;
  }
  const std::chrono::duration<double, std::ratio<60>> minutes(std::strtod(argv[3], nullptr));
  const auto begin = std::chrono::steady_clock::now();
  for (int step = 1; std::chrono::steady_clock::now() - begin < minutes; ++step)
  {
    std::cout << step << std::flush;
    const bool answers = session.Step();
    std::cout << std::endl;
    const bool rests = step % kStepsBetweenRests == 0;
    const long memory = answers && rests ? session.Rest() : 1;
    if (!answers || memory == 0)
    {
      std::cerr << "terrain-view does not answer\n";
      return EXIT_FAILURE;
    }
    if (rests)
    {
      std::cout << "\nrest " << memory << ' ' << session.GetWindows() << std::endl;
    }
  }
  return session.Quit();
}
