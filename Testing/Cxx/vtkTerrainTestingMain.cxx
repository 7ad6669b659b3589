// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainTesting.h"

#include <dlfcn.h>

#include <iostream>

namespace
{
// What ctest is told to take for "skipped".
constexpr int kSkipped = 77;

// Newer versions of Mesa have no OSMesa any more.
bool HasOSMesa()
{
  for (const char* name : { "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so" })
  {
    if (dlopen(name, RTLD_NOW | RTLD_LOCAL))
    {
      return true;
    }
  }
  return false;
}

// Names each test that skipped itself, in a line that .ci/run looks for.
void PrintSkipped(const testing::UnitTest& tests)
{
  for (int suite = 0; suite < tests.total_test_suite_count(); ++suite)
  {
    const testing::TestSuite& cases = *tests.GetTestSuite(suite);
    for (int index = 0; index < cases.total_test_count(); ++index)
    {
      const testing::TestInfo& test = *cases.GetTestInfo(index);
      if (test.should_run() && test.result()->Skipped())
      {
        std::cout << "SKIPPED: " << cases.name() << "." << test.name() << "\n";
      }
    }
  }
}
}

/// Runs the tests of the executable, and names those that skipped: a program of which only some did
/// counts as passed. 0 if they passed, 77 if all of them skipped or the window
/// asked for needs a library that this machine lacks, else 1.
int main(int argc, char** argv)
{
  if (vtkTerrainTesting::WindowName() == "osmesa" && !HasOSMesa())
  {
    std::cout << "Skipped: there is no libOSMesa on this machine\n";
    return kSkipped;
  }
  testing::InitGoogleTest(&argc, argv);
  const int result = RUN_ALL_TESTS();
  const testing::UnitTest* tests = testing::UnitTest::GetInstance();
  const bool allSkipped = result == 0 && tests->skipped_test_count() > 0 &&
    tests->skipped_test_count() == tests->test_to_run_count();
  PrintSkipped(*tests);
  return allSkipped ? kSkipped : result;
}
