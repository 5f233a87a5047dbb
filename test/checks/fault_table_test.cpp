#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "checks/faults.h"
#include "checks/recordings.h"
#include "support/recorded_readings.h"

namespace sfw {
namespace {

using test::notesOf;
using test::Recording;

std::string joined(const std::vector<std::string>& notes) {
  std::string all;
  for (const std::string& note : notes) {
    all += "\n  " + note;
  }
  return all;
}

/// Buildings, seeds and noise that no threshold was chosen on.
std::vector<Recording> cleanRecordings() {
  std::vector<Recording> recordings;
  std::int64_t seed = 500;
  for (const BuildingKind kind : {BuildingKind::kFlat, BuildingKind::kOffice}) {
    for (const char* noise : {"none", "low", "moderate", "realistic"}) {
      for (const std::int64_t access_points : {1, 2, 4}) {
        ++seed;
        recordings.push_back(
            test::simulated(kind, noise, access_points, seed, seed % 2 == 0 ? "walls" : "sparse"));
      }
    }
  }
  return recordings;
}

TEST(FaultTable, CleanRecordingsHaveNoNote) {
  for (const Recording& recording : cleanRecordings()) {
    EXPECT_EQ(joined(notesOf(recording)), "") << recording.name;
  }
}

TEST(FaultTable, CleanRecordingsWithoutPositionsHaveNoNote) {
  for (const std::int64_t seed : {601, 602, 603}) {
    Recording recording = test::simulated(BuildingKind::kFlat, "realistic", 2, seed, "walls");
    test::removePositions(recording);
    EXPECT_EQ(joined(notesOf(recording)), "") << recording.name;
  }
}

TEST(FaultTable, RealRecordingsHaveNoNote) {
  const std::vector<test::RealRecording> recordings = test::realRecordings();
  if (recordings.empty()) {
    GTEST_SKIP() << test::kNoRecordings;
  }
  for (const test::RealRecording& real : recordings) {
    Recording recording{real.name, real.readings, {}};
    const auto heard = test::samplesByRadio(real.readings);
    for (const AccessPoint& access_point : real.access_points) {
      if (heard.count(access_point.bssid) > 0) {
        recording.table.push_back(access_point);
      }
    }
    EXPECT_EQ(joined(notesOf(recording)), "") << recording.name;
  }
}

/// Each fault gives one note, its own: each other note stays silent.
class EachFault : public testing::TestWithParam<test::Fault> {};

TEST_P(EachFault, GivesItsNoteAlone) {
  const test::Fault& fault = GetParam();
  const Recording clean[] = {
      test::simulated(BuildingKind::kFlat, "realistic", 2, 701),
      test::simulated(BuildingKind::kOffice, "realistic", 3, 702),
      test::simulated(BuildingKind::kOffice, "low", 2, 703),
  };
  for (Recording recording : clean) {
    fault.inject(recording);
    const std::vector<std::string> notes = notesOf(recording);
    ASSERT_EQ(notes.size(), 1U) << recording.name << joined(notes);
    EXPECT_NE(notes[0].find(fault.words), std::string::npos) << recording.name << joined(notes);
  }
}

std::string nameOf(const testing::TestParamInfo<test::Fault>& info) {
  std::string name = std::to_string(info.index) + "_";
  for (const char c : info.param.name) {
    name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return name;
}

/// Prints the table of doc/method/checks.md, if SFW_CHECKED_DRIVES is the number of drives.
TEST(FaultTable, RatesOfManyDrives) {
  const char* const drives = std::getenv("SFW_CHECKED_DRIVES");
  if (drives == nullptr) {
    GTEST_SKIP() << "set SFW_CHECKED_DRIVES to a number of drives to measure the rates";
  }
  constexpr const char* kNoise[] = {"none", "low", "moderate", "realistic", "hard"};
  std::vector<Recording> clean;
  for (int i = 0; i < std::stoi(drives); ++i) {
    clean.push_back(test::simulated(i % 2 == 0 ? BuildingKind::kFlat : BuildingKind::kOffice,
                                    kNoise[i % 5], 1 + i % 4, 1000 + i, "walls"));
  }
  std::vector<test::Fault> faults = test::allFaults();
  faults.push_back({"clean", [](Recording&) {}, ""});
  for (const test::Fault& fault : faults) {
    std::size_t found = 0;
    std::size_t others = 0;
    for (Recording recording : clean) {
      fault.inject(recording);
      for (const std::string& note : notesOf(recording)) {
        const bool is_right = !fault.words.empty() && note.find(fault.words) != std::string::npos;
        ++(is_right ? found : others);
        if (!is_right) {
          std::cout << "  " << fault.name << ", " << recording.name << ": " << note << "\n";
        }
      }
    }
    std::cout << "| " << fault.name << " | " << found << " | " << others << " |\n";
    EXPECT_LE(10 * others, clean.size()) << fault.name;
  }
}

INSTANTIATE_TEST_SUITE_P(All, EachFault, testing::ValuesIn(test::allFaults()), nameOf);

}  // namespace
}  // namespace sfw
