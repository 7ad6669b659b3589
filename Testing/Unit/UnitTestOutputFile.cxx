// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Outputs: complete or not at all, and never in place of what must stay.
#include "core/files/OutputFile.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using terrain::OutputFile;
namespace fs = std::filesystem;

namespace
{
/// While it lives, the superuser, who may write everything, is another user, who owns a folder.
class WithoutPrivileges
{
public:
  explicit WithoutPrivileges(const fs::path& folder)
    : Was(geteuid())
  {
    constexpr uid_t nobody = 65534;
    if (this->Was == 0 && chown(folder.c_str(), nobody, static_cast<gid_t>(-1)) == 0)
    {
      EXPECT_EQ(setresuid(nobody, nobody, 0), 0);
    }
  }
  ~WithoutPrivileges()
  {
    EXPECT_EQ(setresuid(this->Was, this->Was, this->Was), 0);
  }
  WithoutPrivileges(const WithoutPrivileges&) = delete;
  void operator=(const WithoutPrivileges&) = delete;

private:
  uid_t Was;
};

class OutputFiles : public testing::Test
{
protected:
  void SetUp() override
  {
    const char* outputs = std::getenv("VTKTERRAIN_TEST_OUTPUT_DIR");
    this->Folder = fs::path(outputs ? outputs : testing::TempDir()) /
      ("outputs" + std::to_string(getpid()) +
        testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder);
  }
  void TearDown() override
  {
    fs::remove_all(this->Folder);
  }
  std::string Path(const std::string& name) const
  {
    return (this->Folder / name).string();
  }
  std::string Content(const std::string& name) const
  {
    std::ifstream in(this->Path(name), std::ios::binary);
    return { std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>() };
  }
  void SetContent(const std::string& name, const std::string& content) const
  {
    std::ofstream(this->Path(name), std::ios::binary) << content;
  }
  std::size_t CountFiles() const
  {
    return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(this->Folder), fs::directory_iterator()));
  }
  /// Writes "new" and gives it its name; the first message.
  static std::string Replace(const std::string& path)
  {
    OutputFile file;
    std::string error = file.Open(path);
    error = error.empty() ? file.Write("new", 3) : error;
    return error.empty() ? file.Commit() : error;
  }

  fs::path Folder;
};
}

TEST_F(OutputFiles, AppearWhenTheyAreCommitted)
{
  this->SetContent("out", "old");
  OutputFile file;
  ASSERT_EQ(file.Open(this->Path("out")), "");
  ASSERT_EQ(file.Write("new ", 4), "");
  ASSERT_EQ(file.Write("content", 7), "");
  EXPECT_EQ(this->Content("out"), "old");
  EXPECT_EQ(this->CountFiles(), 2U);
  ASSERT_EQ(file.Commit(), "");
  EXPECT_EQ(this->Content("out"), "new content");
  EXPECT_EQ(this->CountFiles(), 1U);
  EXPECT_FALSE(file.IsOpen());
}

TEST_F(OutputFiles, GoAwayUnlessTheyAreCommitted)
{
  {
    OutputFile file;
    ASSERT_EQ(file.Open(this->Path("first")), "");
    ASSERT_EQ(file.Open(this->Path("second")), "");
    EXPECT_EQ(this->CountFiles(), 1U);
  }
  EXPECT_EQ(this->CountFiles(), 0U);
}

TEST_F(OutputFiles, ReplaceRegularFilesOnly)
{
  ASSERT_EQ(mkfifo(this->Path("pipe").c_str(), 0666), 0);
  fs::create_directory(this->Path("folder"));
  fs::create_symlink("/dev/null", this->Path("device"));
  fs::create_symlink("nothing", this->Path("dangling"));
  for (const char* name : { "pipe", "folder", "device", "dangling", "folder/", "none/out", "" })
  {
    const std::string path = *name ? this->Path(name) : "";
    EXPECT_NE(Replace(path), "") << name;
  }
  EXPECT_TRUE(fs::is_fifo(this->Path("pipe")));
  EXPECT_TRUE(fs::is_symlink(this->Path("dangling")));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(this->CountFiles(), 4U);
}

TEST_F(OutputFiles, FollowLinksAndKeepPermissions)
{
  fs::create_directory(this->Path("there"));
  this->SetContent("there/target", "old");
  fs::permissions(this->Path("there/target"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("there/target", this->Path("link"));
  ASSERT_EQ(Replace(this->Path("link")), "");
  EXPECT_TRUE(fs::is_symlink(this->Path("link")));
  EXPECT_EQ(this->Content("there/target"), "new");
  EXPECT_EQ(fs::status(this->Path("there/target")).permissions(),
    fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(OutputFiles, RefuseWhatIsProtected)
{
  this->SetContent("out", "old");
  fs::permissions(
    this->Path("out"), fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read);
  const WithoutPrivileges user(this->Folder);
  if (access(this->Folder.c_str(), W_OK) != 0 || access(this->Path("out").c_str(), W_OK) == 0)
  {
    GTEST_SKIP() << "no user here may write the folder and not all files in it";
  }
  EXPECT_NE(Replace(this->Path("out")), "");
  EXPECT_EQ(this->Content("out"), "old");
}

TEST_F(OutputFiles, OfOneNameDoNotMeet)
{
  OutputFile first;
  OutputFile second;
  ASSERT_EQ(first.Open(this->Path("out")), "");
  ASSERT_EQ(second.Open(this->Path("out")), "");
  EXPECT_NE(first.GetPartialPath(), second.GetPartialPath());
  ASSERT_EQ(first.Write("first", 5), "");
  ASSERT_EQ(second.Write("second", 6), "");
  ASSERT_EQ(second.Commit(), "");
  EXPECT_EQ(this->Content("out"), "second");
  ASSERT_EQ(first.Commit(), "");
  EXPECT_EQ(this->Content("out"), "first");
  EXPECT_EQ(this->CountFiles(), 1U);
}

TEST_F(OutputFiles, MayHaveTheLongestNames)
{
  const std::string name(255, 'n');
  EXPECT_EQ(Replace(this->Path(name)), "");
  EXPECT_EQ(this->Content(name), "new");
}

TEST_F(OutputFiles, AreRemovedForSignals)
{
  this->SetContent("done", "old");
  OutputFile first;
  OutputFile second;
  ASSERT_EQ(first.Open(this->Path("first")), "");
  ASSERT_EQ(second.Open(this->Path("second")), "");
  ASSERT_EQ(Replace(this->Path("done")), "");
  terrain::RemovePartialFiles();
  EXPECT_EQ(this->CountFiles(), 1U);
  EXPECT_EQ(this->Content("done"), "new");
  EXPECT_NE(first.Commit(), "");
}

// A limit on the file's size stands for a full disk.
TEST_F(OutputFiles, SayWhenThereIsNoSpace)
{
  this->SetContent("out", "old");
  rlimit before = {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  auto* handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small = { 10, before.rlim_max };
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  std::string error;
  {
    OutputFile file;
    error = file.Open(this->Path("out"));
    error = error.empty() ? file.Write("more than the limit", 19) : error;
  }
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(error, "");
  EXPECT_EQ(this->Content("out"), "old");
  EXPECT_EQ(this->CountFiles(), 1U);
}

TEST_F(OutputFiles, AreToldFromInputs)
{
  this->SetContent("a", "");
  fs::create_symlink("a", this->Path("link"));
  fs::create_hard_link(this->Path("a"), this->Path("hard"));
  this->SetContent("b", "");
  for (const char* name : { "a", "link", "hard", "./a" })
  {
    EXPECT_TRUE(terrain::IsSameFile(this->Path("a"), this->Path(name))) << name;
  }
  EXPECT_FALSE(terrain::IsSameFile(this->Path("a"), this->Path("b")));
  EXPECT_FALSE(terrain::IsSameFile(this->Path("none"), this->Path("none")));
  ASSERT_EQ(mkfifo(this->Path("pipe").c_str(), 0666), 0);
  EXPECT_NE(terrain::WhyNotInput(this->Path("pipe")), "");
  EXPECT_NE(terrain::WhyNotInput("/dev/null"), "");
  EXPECT_EQ(terrain::WhyNotInput(this->Path("a")), "");
  EXPECT_EQ(terrain::WhyNotInput(this->Path("none")), "");
  EXPECT_EQ(terrain::WhyNotInput(this->Path(".")), "");
}
