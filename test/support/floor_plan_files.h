#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "simulation/building/floor_plan_io.h"
#include "structure_from_wifi/input_error.h"

namespace sfw::test {

/// Gives each test a folder of its own to write plans into.
class FloorPlanFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        std::filesystem::path(::testing::TempDir()) / ("plan_files_" + std::string(info->name()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return path(name);
  }

  static std::string complaint(const std::string& file, const FloorPlanOptions& options = {}) {
    try {
      readFloorPlan(file, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  }

  /// The error text of readFloorPlan, without the file's name at its start.
  static std::string complaintOf(const std::string& file, const FloorPlanOptions& options = {}) {
    const std::string text = complaint(file, options);
    EXPECT_EQ(text.rfind(file + ": ", 0), 0u) << text;
    return text.substr(std::min(text.size(), file.size() + 2));
  }

  std::filesystem::path folder_;
};

}  // namespace sfw::test
