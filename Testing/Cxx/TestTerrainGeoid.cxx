// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainGeoid.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainTesting.h"

#include "vtkNew.h"

#include <cmath>
#include <fstream>
#include <string>

namespace
{
using Height = vtkTerrainGeoreference::HeightType;

/// Writes a geoid of the given height everywhere north of the equator, and of 0 far south of it, in
/// GeographicLib's format: 15 degree steps, 16 bit big endian, height = -108 + 0.003 * value.
std::string WriteGeoid(const std::string& name, double height)
{
  const std::string path = vtkTerrainTesting::OutputPath(name + ".pgm");
  std::ofstream file(path, std::ios::binary);
  constexpr int kColumns = 24;
  constexpr int kRows = 13;
  file << "P5\n# Geoid file in PGM format for GeographicLib\n# Description made up by a test\n"
       << "# DateTime 2020-01-01 00:00:00\n# MaxBilinearError 0.1\n# RMSBilinearError 0.1\n"
       << "# MaxCubicError 0.1\n# RMSCubicError 0.1\n# Offset -108\n# Scale 0.003\n"
       << "# Origin 90N 0E\n# AREA_OR_POINT Point\n"
       << kColumns << " " << kRows << "\n65535\n";
  for (int row = 0; row < kRows; ++row)
  {
    for (int column = 0; column < kColumns; ++column)
    {
      const double here = row <= 8 ? height : 0.0;
      const int value = static_cast<int>(std::lround((here + 108.0) / 0.003));
      file.put(static_cast<char>(value >> 8));
      file.put(static_cast<char>(value & 0xff));
    }
  }
  return path.substr(0, path.rfind('/'));
}
}

TEST(TerrainGeoid, NamesWhatIsMissing)
{
  vtkNew<vtkTerrainGeoid> geoid;
  geoid->SetDirectory(vtkTerrainTesting::OutputPath("no-geoids-here"));
  const std::string why = geoid->GetWhyNot();
  EXPECT_NE(why.find("egm96-5.pgm is not in "), std::string::npos) << why;
  EXPECT_NE(why.find("geographiclib-get-geoids egm96-5"), std::string::npos) << why;
  EXPECT_EQ(why.find('\n'), std::string::npos);
  EXPECT_TRUE(std::isnan(geoid->GetHeight(0.0, 0.0)));
  EXPECT_EQ(geoid->GetFileName(), "");
}

TEST(TerrainGeoid, SaysWhenDataAreBroken)
{
  const std::string path = vtkTerrainTesting::OutputPath("broken-geoid.pgm");
  std::ofstream(path) << "P5\nnothing";
  vtkNew<vtkTerrainGeoid> geoid;
  geoid->SetDirectory(path.substr(0, path.rfind('/')));
  geoid->SetModel("broken-geoid");
  EXPECT_NE(geoid->GetWhyNot().find("cannot be read"), std::string::npos) << geoid->GetWhyNot();
  EXPECT_TRUE(std::isnan(geoid->GetHeight(0.0, 0.0)));
}

TEST(TerrainGeoid, ReadsHeights)
{
  vtkNew<vtkTerrainGeoid> geoid;
  geoid->SetDirectory(WriteGeoid("test-geoid", -30.0));
  geoid->SetModel("test-geoid");
  ASSERT_EQ(geoid->GetWhyNot(), "");
  EXPECT_NEAR(geoid->GetHeight(86.9, 28.0), -30.0, 0.002);
  EXPECT_NEAR(geoid->GetHeight(-180.0, 45.0), -30.0, 0.002);
  EXPECT_NEAR(geoid->GetHeight(10.0, -80.0), 0.0, 0.002);
  EXPECT_TRUE(std::isnan(geoid->GetHeight(0.0, 91.0)));
  EXPECT_TRUE(std::isnan(geoid->GetHeight(std::nan(""), 0.0)));
  // Another model: asked again.
  geoid->SetModel("egm2008");
  EXPECT_NE(geoid->GetWhyNot().find("egm2008-1.pgm"), std::string::npos);
}

TEST(TerrainGeoid, ConvertsHeightsOfAScene)
{
  const std::string directory = WriteGeoid("scene-geoid", -30.0);
  for (const bool ellipsoidal : { false, true })
  {
    for (const Height wanted : { Height::AsIs, Height::Ellipsoid, Height::Geoid })
    {
      vtkNew<vtkTerrainGeoreference> reference;
      reference->SetCoordinateSystem("EPSG:32645");
      reference->SetExtent(470000.0, 500000.0, 3080000.0, 3110000.0);
      reference->SetFileHeights(ellipsoidal ? Height::Ellipsoid : Height::Geoid);
      reference->SetSceneHeights(wanted);
      reference->GetGeoid()->SetDirectory(directory);
      reference->GetGeoid()->SetModel("scene-geoid");
      ASSERT_EQ(reference->GetWhyNot(), "");
      double expected = 1000.0;
      if (wanted == Height::Ellipsoid && !ellipsoidal)
      {
        expected = 970.0;
      }
      if (wanted == Height::Geoid && ellipsoidal)
      {
        expected = 1030.0;
      }
      const double file[3] = { 480000.0, 3090000.0, 1000.0 };
      for (const auto frame :
        { vtkTerrainGeoreference::FrameType::Plane, vtkTerrainGeoreference::FrameType::Grid })
      {
        reference->SetFrame(frame);
        double scene[3];
        double back[3];
        ASSERT_TRUE(reference->FileToScene(file, scene, 1));
        EXPECT_NEAR(scene[2], expected, 0.002);
        ASSERT_TRUE(reference->SceneToFile(scene, back, 1));
        EXPECT_NEAR(back[2], 1000.0, 1e-6);
        EXPECT_NEAR(back[0], file[0], 1e-3);
      }
    }
  }
}

TEST(TerrainGeoid, MissingDataStopOnlyConversions)
{
  vtkNew<vtkTerrainGeoreference> reference;
  reference->SetCoordinateSystem("EPSG:32645");
  reference->SetExtent(470000.0, 500000.0, 3080000.0, 3110000.0);
  reference->GetGeoid()->SetDirectory(vtkTerrainTesting::OutputPath("no-geoids-here"));
  EXPECT_EQ(reference->GetWhyNot(), "");
  reference->SetSceneHeights(Height::Geoid);
  EXPECT_EQ(reference->GetWhyNot(), "") << "sea level to sea level";
  reference->SetSceneHeights(Height::Ellipsoid);
  EXPECT_NE(reference->GetWhyNot().find("egm96-5.pgm"), std::string::npos);
  reference->SetCoordinateSystem("");
  reference->SetFrame(vtkTerrainGeoreference::FrameType::Grid);
  EXPECT_NE(reference->GetWhyNot().find("where the coordinate system is known"), std::string::npos);
}
