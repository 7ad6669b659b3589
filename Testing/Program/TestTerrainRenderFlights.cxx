// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Flights: where the camera goes, which frames are drawn, what becomes of them.
#include "TerrainRenderFixture.h"

#include "vtk_jsoncpp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

namespace fs = std::filesystem;

namespace
{
using Numbers = std::vector<double>;

class TerrainRenderFlights : public TerrainRenderFixture
{
protected:
  void SetUp() override
  {
    TerrainRenderFixture::SetUp();
    this->Hill = this->WriteHill();
  }

  RunResult Fly(const std::vector<std::string>& more, long fileLimit = 0) const
  {
    std::vector<std::string> arguments = { this->Hill, "--size", "64x48", "--stats", "stats.json" };
    arguments.insert(arguments.end(), more.begin(), more.end());
    return this->Run(arguments, fileLimit);
  }

  int Statistic(const std::string& key) const
  {
    Json::Value root;
    std::ifstream(this->Path("stats.json")) >> root;
    return root[key].asInt();
  }

  /// The rows of flight.csv: time, eye, focal point.
  std::vector<Numbers> ReadViews(const std::string& folder) const
  {
    std::istringstream text(this->ReadText(folder + "/flight.csv"));
    std::string line;
    std::getline(text, line);
    EXPECT_EQ(line, "seconds,x,y,z,look_x,look_y,look_z");
    std::vector<Numbers> views;
    while (std::getline(text, line))
    {
      std::replace(line.begin(), line.end(), ',', ' ');
      std::istringstream cells(line);
      Numbers row(7);
      for (double& cell : row)
      {
        cells >> cell;
      }
      EXPECT_TRUE(cells) << line;
      views.push_back(row);
    }
    return views;
  }

  int CountFrames(const std::string& folder) const
  {
    int frames = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(this->Path(folder)))
    {
      frames += entry.path().extension() == ".png" ? 1 : 0;
    }
    return frames;
  }

  /// A program in place of ffmpeg, in a folder of its own, and the words to run with it alone.
  std::vector<std::string> WithFilmMaker(const std::string& script,
    const std::string& size = "64x48", const std::string& flight = "spin:0.5") const
  {
    fs::create_directory(this->Path("bin"));
    this->WriteText("bin/ffmpeg", "#!/bin/sh\n" + script);
    fs::permissions(this->Path("bin/ffmpeg"), fs::perms::owner_all);
    return { "/usr/bin/env", "PATH=" + this->Path("bin") + ":/bin:/usr/bin", Program(), this->Hill,
      "--size", size, "--flight", flight, "--fps", "6" };
  }

  std::string Hill;
};

double Height(double x, double y)
{
  // of the fixture's hill, whose rows run south: 49 samples of 1 m from y = -0.5 down
  const double i = x - 0.5;
  const double j = -y - 0.5;
  return 20.0 * std::exp(-((i - 32.0) * (i - 32.0) + (j - 24.0) * (j - 24.0)) / 150.0);
}
}

TEST_F(TerrainRenderFlights, SpinIsSteadyAndOrbitEased)
{
  const RunResult spin = this->Fly({ "--flight", "spin:2", "--fps", "4", "--output", "spin" });
  EXPECT_EQ(spin.Status, 0) << spin.Errors;
  EXPECT_EQ(spin.Output, this->Path("spin") + "\n");
  EXPECT_EQ(this->CountFrames("spin"), 8);
  EXPECT_EQ(this->Statistic("flight_frames_drawn"), 8);
  const std::vector<Numbers> steady = this->ReadViews("spin");
  ASSERT_EQ(steady.size(), 8U);
  const auto turn = [](const Numbers& a, const Numbers& b)
  {
    const double angle =
      std::atan2(b[2] - b[5], b[1] - b[4]) - std::atan2(a[2] - a[5], a[1] - a[4]);
    return std::remainder(angle, 8.0 * std::atan(1.0));
  };
  for (std::size_t k = 0; k < 8; ++k)
  {
    EXPECT_NEAR(turn(steady[k], steady[(k + 1) % 8]), std::atan(1.0), 1e-6) << k;
    EXPECT_NEAR(std::hypot(steady[k][1] - steady[k][4], steady[k][2] - steady[k][5]),
      std::hypot(steady[0][1] - steady[0][4], steady[0][2] - steady[0][5]), 1e-6);
  }
  EXPECT_EQ(
    this->Fly({ "--flight", "orbit", "--flight-seconds", "3", "--fps", "7", "--output", "orbit" })
      .Status,
    0);
  const std::vector<Numbers> eased = this->ReadViews("orbit");
  ASSERT_EQ(eased.size(), 21U);
  EXPECT_NEAR(turn(eased[0], eased[20]), 0.0, 1e-6);
  EXPECT_LT(turn(eased[0], eased[1]), 0.4 * turn(eased[9], eased[10]));
  EXPECT_NEAR(turn(eased[0], eased[1]), turn(eased[19], eased[20]), 1e-6);
  // each frame is the picture of its camera
  std::ostringstream camera;
  for (std::size_t k = 1; k < 7; ++k)
  {
    camera << (k > 1 ? "," : "") << steady[3][k];
  }
  EXPECT_EQ(this->Fly({ "--camera", camera.str(), "--output", "still.png" }).Status, 0);
  const Picture still = this->ReadPicture("still.png");
  const Picture frame = this->ReadPicture("spin/frame-00004.png");
  int off = 0;
  for (std::size_t k = 0; k < still.Values.size(); ++k)
  {
    off += std::abs(int{ still.Values[k] } - int{ frame.Values[k] }) > 4 ? 1 : 0;
  }
  EXPECT_LT(off, 30) << "of " << still.Values.size();
}

TEST_F(TerrainRenderFlights, NeverBelowGround)
{
  // straight through the hill, whose top is at 32.5, -24.5
  this->WriteText("through.csv", "seconds,x,y,z\n0,2,-24.5,6\n2,32,-24.5,5\n4,63,-24.5,6\n");
  const RunResult result =
    this->Fly({ "--flight", "through.csv", "--fps", "10", "--output", "through" });
  EXPECT_EQ(result.Status, 0) << result.Errors;
  const std::vector<Numbers> views = this->ReadViews("through");
  ASSERT_EQ(views.size(), 40U);
  double least = 1e9;
  for (std::size_t k = 0; k < views.size(); ++k)
  {
    least = std::min(least, views[k][3] - Height(views[k][1], views[k][2]));
    if (k > 1)
    {
      const double bend = views[k][3] - 2.0 * views[k - 1][3] + views[k - 2][3];
      EXPECT_LT(std::abs(bend), 0.8) << "smoothly over it, frame " << k;
    }
  }
  EXPECT_GT(least, 2.5);
  EXPECT_NEAR(this->Statistic("flight_least_height"), std::floor(least), 1.0);
  EXPECT_NEAR(views.front()[1], 2.0, 1e-6);
  EXPECT_NEAR(views.back()[1], 63.0, 1e-6);
  EXPECT_LT(views[1][1] - views[0][1], 0.2 * (views[11][1] - views[10][1])) << "eased";
}

TEST_F(TerrainRenderFlights, GoesOnWhereItStopped)
{
  const std::vector<std::string> flight = { "--flight", "spin:1", "--fps", "6", "--output",
    "spin" };
  EXPECT_EQ(this->Fly(flight).Status, 0);
  const std::string last = this->ReadText("spin/frame-00006.png");
  const std::string kept = "kept";
  this->WriteText("spin/frame-00001.png", kept);
  fs::remove(this->Path("spin/frame-00006.png"));
  EXPECT_EQ(this->Fly(flight).Status, 0);
  EXPECT_EQ(this->Statistic("flight_frames"), 6);
  EXPECT_EQ(this->Statistic("flight_frames_drawn"), 1);
  EXPECT_EQ(this->ReadText("spin/frame-00006.png"), last);
  EXPECT_EQ(this->ReadText("spin/frame-00001.png"), kept);
  // another flight, or anything else in the folder
  std::vector<std::string> other = flight;
  other.insert(other.end(), { "--exaggeration", "2" });
  ExpectRefused(this->Fly(other), 1, "it holds frames of another flight");
  EXPECT_EQ(this->CountFrames("spin"), 6);
  fs::create_directory(this->Path("mine"));
  this->WriteText("mine/letter.txt", "Dear reader\n");
  ExpectRefused(
    this->Fly({ "--flight", "orbit", "--output", "mine" }), 1, "it is not empty, and holds no");
  // the folder's scene draws the flight again
  EXPECT_EQ(this->Run({ "--scene", "spin/scene.toml", "--output", "again" }).Status, 0);
  EXPECT_EQ(this->ReadText("again/frame-00006.png"), last);
}

TEST_F(TerrainRenderFlights, TerminalsSeeTheTimeThatIsLeft)
{
  const std::string terminal = "/usr/bin/script";
  const std::string typescript = this->Path("typescript");
  if (this->RunCommand({ terminal, "-qec", "true", typescript }).Status != 0)
  {
    GTEST_SKIP() << "there is no terminal to be had";
  }
  const RunResult shown = this->RunCommand({ terminal, "-qec",
    Program() + " " + this->Hill + " --size 64x48 --flight spin:1 --fps 4 --output spin",
    typescript });
  EXPECT_EQ(shown.Status, 0);
  EXPECT_NE(shown.Output.find("] 50 % drawing, 0:0"), std::string::npos) << shown.Output;
  EXPECT_NE(shown.Output.find("100 % drawing, 0:00 left"), std::string::npos) << shown.Output;
}

TEST_F(TerrainRenderFlights, FullDiskKeepsFramesMade)
{
  // The first frame shows the sky alone, and takes less than the disk has; those of the hill more.
  this->WriteText("down.csv",
    "seconds,x,y,z,look_x,look_y,look_z\n0,32,-90,60,32,-91,200\n2,32,-90,60,32,-24,5\n");
  const auto fly = [this](const std::string& output, long disk)
  {
    return this->Run({ this->Hill, "--size", "200x150", "--flight", "down.csv", "--fps", "4",
                       "--output", output, "--contours", "1" },
      disk);
  };
  ASSERT_EQ(fly("whole", 0).Status, 0);
  const std::uintmax_t sky = fs::file_size(this->Path("whole/frame-00001.png"));
  const std::uintmax_t hill = fs::file_size(this->Path("whole/frame-00008.png"));
  ASSERT_LT(sky + 500, hill);
  const RunResult result = fly("down", static_cast<long>((sky + hill) / 2));
  EXPECT_EQ(result.Status, 1);
  EXPECT_EQ(std::count(result.Errors.begin(), result.Errors.end(), '\n'), 1) << result.Errors;
  EXPECT_NE(result.Errors.find("down/frame-0000"), std::string::npos) << result.Errors;
  const int frames = this->CountFrames("down");
  EXPECT_GE(frames, 1);
  EXPECT_LT(frames, 8);
  for (const fs::directory_entry& entry : fs::directory_iterator(this->Path("down")))
  {
    const std::string name = entry.path().filename().string();
    const bool isWhole = entry.path().extension() != ".png" ||
      this->ReadPictureSize("down/" + name) == std::vector<int>{ 200, 150 };
    EXPECT_TRUE(isWhole) << name;
    EXPECT_TRUE(isWhole && name.find("partial") == std::string::npos) << name;
  }
}

// ffmpeg as the tests have it: it takes its words down, and its input for a film.
const char* const kRecorder = "echo \"$@\" >> \"${0%/*}/words\"\nfor last; do :; done\n"
                              "case \"$*\" in *pipe:0*) cat;; *) cat spin-frames/*.png;; esac "
                              "> \"$last\"\n";

TEST_F(TerrainRenderFlights, FilmsAreEncodedWhileFramesAreDrawn)
{
  std::vector<std::string> command = this->WithFilmMaker(kRecorder);
  command.insert(command.end(), { "--output", "spin.mp4" });
  const RunResult film = this->RunCommand(command);
  EXPECT_EQ(film.Status, 0) << film.Errors;
  EXPECT_EQ(film.Output, this->Path("spin.mp4") + "\n");
  EXPECT_EQ(this->CountFrames("spin-frames"), 0);
  // three frames of three bytes a pixel, the lowest row first; then a list of the parts
  EXPECT_EQ(this->ReadText("spin-frames/frames-00001-00003.mp4").size(), 3U * 64U * 48U * 3U);
  EXPECT_EQ(this->ReadText("spin.mp4"),
    "file 'file:" + this->Path("spin-frames/frames-00001-00003.mp4") + "'\nduration 0.500000\n");
  const std::string words = this->ReadText("bin/words");
  EXPECT_NE(words.find("-video_size 64x48 -framerate 6.0"), std::string::npos) << words;
  EXPECT_NE(words.find("libx264"), std::string::npos) << words;
  EXPECT_NE(words.find("-f concat"), std::string::npos) << words;
  // another kind of film has parts of its own
  command.back() = "spin.webm";
  EXPECT_EQ(this->RunCommand(command).Status, 0);
  EXPECT_NE(this->ReadText("bin/words").find("libvpx-vp9"), std::string::npos);
  EXPECT_TRUE(fs::exists(this->Path("spin-frames/frames-00001-00003.webm")));
}

TEST_F(TerrainRenderFlights, FilmsAreMadeOfFrames)
{
  std::vector<std::string> command = this->WithFilmMaker(kRecorder);
  command.insert(command.end(), { "--output", "spin.gif" });
  EXPECT_EQ(this->RunCommand(command).Status, 0);
  EXPECT_EQ(this->CountFrames("spin-frames"), 3);
  EXPECT_EQ(this->ReadText("spin.gif").substr(1, 3), "PNG");
  const std::string words = this->ReadText("bin/words");
  EXPECT_NE(words.find("-framerate 6.0"), std::string::npos) << words;
  EXPECT_NE(words.find("-i spin-frames/frame-%05d.png"), std::string::npos) << words;
  EXPECT_NE(words.find("palettegen"), std::string::npos);
  // of the same frames other kinds
  command.back() = "spin.webp";
  EXPECT_EQ(this->RunCommand(command).Status, 0);
  EXPECT_NE(this->ReadText("bin/words").find("libwebp_anim"), std::string::npos);
  command.back() = "spin.mp4";
  EXPECT_EQ(this->RunCommand(command).Status, 0);
  EXPECT_EQ(this->ReadText("spin.mp4").substr(1, 3), "PNG");
}

/// The frames of a film, red, green, blue, as ffmpeg decodes them.
std::string Decode(const std::string& film)
{
  const std::string raw = film + ".raw";
  const std::string command =
    "ffmpeg -loglevel error -y -i '" + film + "' -f rawvideo -pix_fmt rgb24 '" + raw + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::ifstream file(raw, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// A film in parts, the second of which is made anew, has the frames of the flight in their order
// and colours.
TEST_F(TerrainRenderFlights, FilmsHaveTheFramesOfTheFlight)
{
  if (std::system("ffmpeg -loglevel quiet -encoders 2>/dev/null | grep -q libx264") != 0)
  {
    GTEST_SKIP() << "there is no ffmpeg with x264 here";
  }
  const auto fly = [this](const std::string& output)
  {
    return this->Run(
      { this->Hill, "--size", "96x63", "--flight", "spin:7", "--fps", "3", "--output", output });
  };
  ASSERT_EQ(fly("spin").Status, 0);
  const RunResult first = fly("spin.mp4");
  ASSERT_EQ(first.Status, 0) << first.Errors;
  const std::string part = this->Path("spin-frames/frames-00016-00021.mp4");
  ASSERT_TRUE(fs::remove(part));
  fs::remove(this->Path("spin.mp4"));
  ASSERT_EQ(fly("spin.mp4").Status, 0);
  EXPECT_TRUE(fs::exists(part));
  const std::string frames = Decode(this->Path("spin.mp4"));
  constexpr int kEvenHeight = 64; // its last row is black
  ASSERT_EQ(frames.size(), 21U * 96U * kEvenHeight * 3U);
  for (int k = 0; k < 21; ++k)
  {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "spin/frame-%05d.png", k + 1);
    const Picture still = this->ReadPicture(name.data());
    double sum = 0.0;
    for (std::size_t byte = 0; byte < still.Values.size(); ++byte)
    {
      sum += std::abs(int{ still.Values[byte] } -
        int{ static_cast<unsigned char>(frames[k * 96U * kEvenHeight * 3U + byte]) });
    }
    EXPECT_LT(sum / static_cast<double>(still.Values.size()), 6.0) << "frame " << k;
  }
  std::string times;
  FILE* probe = popen(
    ("ffprobe -v error -show_entries packet=pts_time -of csv=p=0 '" + this->Path("spin.mp4") + "'")
      .c_str(),
    "r");
  for (int letter = std::fgetc(probe); letter != EOF; letter = std::fgetc(probe))
  {
    times += static_cast<char>(letter);
  }
  EXPECT_EQ(pclose(probe), 0);
  std::istringstream lines(times);
  for (int k = 0; k < 21; ++k)
  {
    double seconds = -1.0;
    lines >> seconds;
    EXPECT_NEAR(seconds, k / 3.0, 1e-4);
  }
}

// As the container's specification has it: RIFF, WEBP, ANIM, and a chunk ANMF for each frame.
TEST_F(TerrainRenderFlights, AnimatedWebPHasAllFrames)
{
  if (std::system("ffmpeg -loglevel quiet -encoders 2>/dev/null | grep -q libwebp_anim") != 0)
  {
    GTEST_SKIP() << "there is no ffmpeg with libwebp here";
  }
  const RunResult film =
    this->Fly({ "--flight", "spin:0.5", "--fps", "6", "--output", "spin.webp" });
  EXPECT_EQ(film.Status, 0) << film.Errors;
  const std::string bytes = this->ReadText("spin.webp");
  EXPECT_EQ(bytes.substr(0, 4), "RIFF");
  EXPECT_EQ(bytes.substr(8, 4), "WEBP");
  EXPECT_NE(bytes.find("ANIM"), std::string::npos);
  int frames = 0;
  for (std::size_t at = bytes.find("ANMF"); at != std::string::npos;
       at = bytes.find("ANMF", at + 4))
  {
    ++frames;
  }
  EXPECT_EQ(frames, 3);
}

TEST_F(TerrainRenderFlights, FilmsThatCannotBeMade)
{
  std::vector<std::string> command = this->WithFilmMaker("echo no codec >&2\nexit 3\n");
  command.insert(command.end(), { "--output", "spin.webm" });
  ExpectRefused(
    this->RunCommand(command), 1, "spin.webm: ffmpeg made no film (no codec); no frame is kept");
  command.back() = "spin.gif";
  ExpectRefused(this->RunCommand(command), 1, "ffmpeg made no film (no codec); the frames are in");
  EXPECT_EQ(this->CountFrames("spin-frames"), 3);
  EXPECT_FALSE(fs::exists(this->Path("spin.webm")));
  EXPECT_FALSE(fs::exists(this->Path("spin.gif")));
  fs::remove(this->Path("bin/ffmpeg"));
  command[1] = "PATH=" + this->Path("bin");
  ExpectRefused(this->RunCommand(command), 2, "ffmpeg, which is not on the PATH: install it");
}

// It takes 20 frames and ends, well or not; the second time it ends in the second part.
TEST_F(TerrainRenderFlights, FilmMakersThatEndEarly)
{
  const auto fly = [this](const std::string& script)
  {
    std::vector<std::string> command = this->WithFilmMaker(script, "160x120", "spin:15");
    command.insert(command.end(), { "--output", "spin.mp4" });
    return this->RunCommand(command);
  };
  const std::string takesSome = "for last; do :; done\nhead -c 1152000 > \"$last\"\n";
  ExpectRefused(fly(takesSome + "echo the disk is full >&2\nexit 1\n"), 1,
    "spin.mp4: ffmpeg made no film (the disk is full); no frame is kept");
  const std::string inTheSecond = "case \"$*\" in *frames-00031*) " + takesSome +
    "kill -9 $$;; *) for last; do :; done; cat > \"$last\";; esac\n";
  ExpectRefused(fly(inTheSecond), 1,
    "ffmpeg made no film; 30 of 90 frames are kept in 'spin-frames', and the same command goes on");
  std::vector<std::string> left;
  for (const fs::directory_entry& entry : fs::directory_iterator(this->Path("spin-frames")))
  {
    left.push_back(entry.path().filename().string());
  }
  std::sort(left.begin(), left.end());
  EXPECT_EQ(
    left, (std::vector<std::string>{ "flight.csv", "frames-00001-00030.mp4", "scene.toml" }));
  EXPECT_FALSE(fs::exists(this->Path("spin.mp4")));
  const RunResult rest = fly("for last; do :; done\ncat > \"$last\"\n");
  EXPECT_EQ(rest.Status, 0) << rest.Errors;
  EXPECT_EQ(this->ReadText("spin-frames/frames-00031-00060.mp4").size(), 30U * 160U * 120U * 3U);
  EXPECT_NE(this->ReadText("spin.mp4").find("frames-00061-00090.mp4"), std::string::npos);
}

// ffmpeg itself on a disk that is full after a part or two.
TEST_F(TerrainRenderFlights, FullDiskKeepsPartsMade)
{
  if (std::system("ffmpeg -loglevel quiet -encoders 2>/dev/null | grep -q libx264") != 0)
  {
    GTEST_SKIP() << "there is no ffmpeg with x264 here";
  }
  // five seconds of the sky alone, then of the hill
  this->WriteText("down.csv",
    "seconds,x,y,z,look_x,look_y,look_z\n0,32,-90,60,32,-91,200\n"
    "6,32,-90,60,32,-91,200\n12,32,-60,40,32,-24,5\n");
  const auto fly = [this](long disk)
  {
    return this->Run({ this->Hill, "--size", "200x150", "--flight", "down.csv", "--fps", "4",
                       "--output", "down.mp4", "--contours", "1" },
      disk);
  };
  const RunResult full = fly(30000);
  EXPECT_EQ(full.Status, 1);
  EXPECT_EQ(std::count(full.Errors.begin(), full.Errors.end(), '\n'), 1) << full.Errors;
  EXPECT_NE(full.Errors.find("File too large"), std::string::npos) << full.Errors;
  EXPECT_NE(full.Errors.find("0 of 48 frames are kept in 'down-frames'"), std::string::npos)
    << full.Errors;
  EXPECT_FALSE(fs::exists(this->Path("down.mp4")));
  EXPECT_TRUE(fs::exists(this->Path("down-frames/frames-00001-00020.mp4")));
  for (const fs::directory_entry& entry : fs::directory_iterator(this->Path("down-frames")))
  {
    EXPECT_EQ(entry.path().string().find("partial"), std::string::npos) << entry.path();
  }
  EXPECT_EQ(fly(0).Status, 0);
  EXPECT_EQ(Decode(this->Path("down.mp4")).size(), 48U * 200U * 150U * 3U);
}

TEST_F(TerrainRenderFlights, TracksAreSeenFromBehind)
{
  RasterDescription plain;
  plain.Width = 91;
  plain.Height = 81;
  plain.CoordinateSystem = "EPSG:32645";
  plain.GeoTransform = { 490000.0, 30.0, 0.0, 3100000.0, 0.0, -30.0 };
  plain.Sample = [](int i, int j)
  { return 5.0 * std::sin(0.2 * i) + 5.0 * std::cos(0.2 * j) + 40.0; };
  this->Hill = this->WriteRaster("plain.tif", plain);
  // from west to east through the middle
  this->WriteText("track.geojson",
    R"({"type":"LineString","coordinates":[[86.9015,28.014],[86.909,28.014],[86.922,28.014]]})");
  const RunResult result = this->Fly({ "--flight", "track.geojson", "--fps", "5",
    "--flight-seconds", "2", "--exaggeration", "3", "--output", "along" });
  EXPECT_EQ(result.Status, 0) << result.Errors;
  const std::vector<Numbers> views = this->ReadViews("along");
  ASSERT_EQ(views.size(), 10U);
  for (const Numbers& view : views)
  {
    EXPECT_LT(view[1], view[4]) << "the eye is west of what it sees";
    EXPECT_NEAR(view[2], view[5], 30.0);
    EXPECT_GT(view[3], view[6] + 50.0);
  }
  EXPECT_GT(views.back()[4] - views.front()[4], 1000.0);
}

// Along 1,500 m: the first 500 m in 900 s, the rest in 100 s.
TEST_F(TerrainRenderFlights, TimesOfTracksAreHonoured)
{
  RasterDescription plain;
  plain.Width = 121;
  plain.Height = 81;
  plain.CoordinateSystem = "EPSG:32645";
  plain.GeoTransform = { 490000.0, 30.0, 0.0, 3100000.0, 0.0, -30.0 };
  plain.Sample = [](int i, int) { return 0.5 * i; };
  this->Hill = this->WriteRaster("plain.tif", plain);
  const auto writeTrack = [this](const std::array<const char*, 3>& times)
  {
    std::ostringstream text;
    text << R"(<gpx version="1.1" xmlns="http://www.topografix.com/GPX/1/1"><trk><trkseg>)";
    const std::array<double, 3> longitudes = { 86.908, 86.91308, 86.92324 };
    for (std::size_t k = 0; k < times.size(); ++k)
    {
      text << "<trkpt lat=\"28.014\" lon=\"" << longitudes[k] << "\"><time>2024-06-21T" << times[k]
           << "Z</time></trkpt>";
    }
    text << "</trkseg></trk></gpx>";
    this->WriteText("track.gpx", text.str());
  };
  const auto fly = [this](const std::string& output, const std::string& more)
  {
    std::vector<std::string> options = { "--flight", "track.gpx", "--fps", "10", "--flight-seconds",
      "10.1", "--output", output };
    if (!more.empty())
    {
      options.push_back(more);
    }
    const RunResult result = this->Fly(options);
    EXPECT_EQ(result.Status, 0) << result.Errors;
    const std::vector<Numbers> views = this->ReadViews(output);
    EXPECT_EQ(views.size(), 101U);
    return std::pair(views, result.Errors);
  };
  writeTrack({ "10:00:00", "10:15:00", "10:16:40" });
  const auto [timed, none] = fly("timed", "");
  EXPECT_EQ(none, "");
  const auto moved = [](const std::vector<Numbers>& views, std::size_t from, std::size_t to)
  { return std::abs(views[to][4] - views[from][4]); };
  // steps far from the ends: 5 m and 100 m a frame
  EXPECT_NEAR(moved(timed, 40, 70) / 30.0, 500.0 / 90.0, 1.0);
  EXPECT_GT(moved(timed, 92, 96) / 4.0, 40.0);
  const auto [even, nothing] = fly("even", "--even-speed");
  EXPECT_GT(moved(even, 40, 70) / 30.0, 12.0);
  this->WriteText("one.gpx",
    R"(<gpx version="1.1" xmlns="http://www.topografix.com/GPX/1/1"><trk><trkseg><trkpt )"
    R"(lat="28.014" lon="86.91"><time>2024-06-21T10:00:00Z</time></trkpt></trkseg></trk></gpx>)");
  ExpectRefused(this->Fly({ "--flight", "one.gpx", "--output", "one" }), 1, "two places or more");
  writeTrack({ "10:00:00", "09:15:00", "10:16:40" });
  const auto [back, warning] = fly("back", "");
  EXPECT_NE(warning.find("its times go back at 2024/06/21 09:15:00"), std::string::npos) << warning;
  EXPECT_NEAR(back[50][4], even[50][4], 1e-6);
}

TEST_F(TerrainRenderFlights, WrongFlightsAreOneSentence)
{
  const auto refuse =
    [&](const std::string& text, const std::string& mention, const std::string& name = "f.csv")
  {
    this->WriteText(name, text);
    ExpectRefused(this->Fly({ "--flight", name, "--output", "out" }), 1, mention);
    EXPECT_FALSE(fs::exists(this->Path("out")));
  };
  refuse("", "its first line must name the columns");
  refuse("time,x,y,z\n0,1,1,1\n", "its first line must name the columns");
  refuse("seconds,x,y,z\n", "there are none");
  refuse("seconds,x,y,z\n0,1,1,1\n", "two places or more, there is one");
  refuse("seconds,x,y,z\n0,1,1,1\n1,2,b,3\n", "f.csv, line 3: 'b' is no y");
  refuse("seconds,x,y,z\n0,1,1,1\n1,2\n", "f.csv, line 3: '' is no y");
  refuse("seconds,x,y,z\n0,1,1,1\n0,2,2,3\n", "seconds must rise from line to line");
  refuse("seconds,lon,lat,height\n0,1,1,1\n1,2,2,3\n", "places need a raster that is somewhere");
  refuse("<gpx></gpx>", "a track needs a raster that is somewhere", "f.gpx");
  refuse("seconds,x,y,z\n0,1,1,1\n90000,2,2,3\n", "frames, at most 99999");
  const auto misuse = [&](const std::vector<std::string>& options, const std::string& mention)
  { ExpectRefused(this->Fly(options), 2, mention); };
  misuse({ "--flight", "nowhere.gpx" }, "is neither orbit, spin:SECONDS nor a file");
  misuse({ "--flight", "spin:0" }, "--flight");
  misuse({ "--flight", "orbit", "--output", "x.png" }, "a flight makes many pictures");
  misuse({ "--flight", "orbit", "--depth", "x.tif" }, "--depth");
  misuse({ "--flight-seconds", "3" }, "needs --flight");
  misuse({ "--even-speed" }, "needs --flight");
  misuse({ "--flight", "orbit", "--sun", "2024-06-21T01:30Z/2024-06-21T11:30Z/300" }, "one sun");
}

TEST_F(TerrainRenderFlights, OtherOutputsLieBesideTheFrames)
{
  const std::vector<std::string> before = this->ListFiles();
  for (const char* option : { "--stats", "--save-scene" })
  {
    ExpectRefused(
      this->Run({ this->Hill, "--flight", "orbit", "--output", "new", option, "new/file" }), 2,
      "which is for the frames alone");
    ExpectRefused(
      this->Run({ this->Hill, "--flight", "orbit", "--output", "new/", option, "./new/a/file" }), 2,
      option);
  }
  EXPECT_EQ(this->ListFiles(), before);
}
