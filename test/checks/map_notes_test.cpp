#include "structure_from_wifi/map_notes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "output/report.h"
#include "support/mapper_scene.h"

namespace sfw {
namespace {

const Position kAccessPoint(2.0, 1.5);

using Place = std::function<Position(int)>;
using Signal = std::function<double(const Position&)>;

/// Lanes through a hall of 8 x 5 m.
Position lanes(int i) {
  const int lane = i / 80;
  return {0.1 * (lane % 2 == 0 ? i % 80 : 80 - i % 80), lane};
}

double fading(const Position& place) {
  return -40.0 - 20.0 * std::log10(std::max(0.3, (place - kAccessPoint).norm()));
}

std::vector<std::string> textsOf(const Snapshot& snapshot, const DataFindings& findings = {}) {
  std::vector<std::string> texts;
  for (const MapNote& note : mapNotes(snapshot, findings)) {
    texts.push_back(note.text);
  }
  return texts;
}

/// Maps a drive with both methods: the same notes have to come from either.
std::string notesOf(const Place& place, const Signal& signal, int count, int radio = 1) {
  std::optional<std::string> notes;
  for (const char* method : {"tomography", "k_visibility"}) {
    Config config = test::rawConfig();
    config.method = method;
    Mapper mapper(config, {test::accessPoint(1, kAccessPoint.x(), kAccessPoint.y())});
    for (int i = 0; i < count; ++i) {
      const Position at = place(i);
      mapper.insert(test::reading(i, at.x(), at.y(), signal(at), radio));
    }
    const auto snapshot = mapper.infer();
    EXPECT_TRUE(snapshot);
    std::string all;
    for (const std::string& note : textsOf(*snapshot)) {
      all += note + '\n';
      EXPECT_NE(reportJson(*snapshot, config).find(note), std::string::npos) << note;
    }
    EXPECT_EQ(notes.value_or(all), all) << method;
    notes = all;
  }
  return *notes;
}

bool contain(const std::string& notes, const char* text) {
  return notes.find(text) != std::string::npos;
}

TEST(MapNotes, AreEmptyForAGoodDrive) { EXPECT_EQ(notesOf(lanes, fading, 400), ""); }

TEST(MapNotes, ReportASingleReading) {
  const std::string notes = notesOf(lanes, fading, 1);
  EXPECT_TRUE(contain(notes, "hardly moved")) << notes;
}

TEST(MapNotes, ReportAStraightPathInAnyDirection) {
  for (const double bearing : {0.0, 0.6, 1.57}) {
    const auto straight = [&](int i) {
      return Position(0.1 * i * std::cos(bearing), 0.1 * i * std::sin(bearing));
    };
    const std::string notes = notesOf(straight, fading, 80);
    EXPECT_TRUE(contain(notes, "path is straight")) << notes;
  }
}

TEST(MapNotes, ReportEqualSignals) {
  const std::string notes = notesOf(
      lanes, [](const Position&) { return -60.0; }, 400);
  EXPECT_TRUE(contain(notes, "are equal and contain no information")) << notes;
}

TEST(MapNotes, ReportThatAllRadiosAreUnknown) {
  const std::string notes = notesOf(lanes, fading, 400, 2);
  EXPECT_TRUE(contain(notes, "no reading of an access point of the table can be used")) << notes;
}

TEST(MapNotes, ReportThatThereIsNoReading) {
  const Mapper mapper(test::rawConfig(), {test::accessPoint(1, 2.0, 1.5)});
  const std::vector<std::string> notes = textsOf(*mapper.infer());
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].rfind("no pose is known: the map is empty; check the topics", 0), 0U);
  for (const MapNote& note : mapNotes(*mapper.infer())) {
    EXPECT_FALSE(isFault(note)) << note.text;  // each drive begins so
  }
}

TEST(MapNotes, ReportSignalsThatNoRadioReceives) {
  int reading = 0;
  const auto sometimes_zero = [&](const Position& at) {
    return ++reading % 20 == 0 ? 0.0 : fading(at);
  };
  const std::string notes = notesOf(lanes, sometimes_zero, 400);
  EXPECT_TRUE(contain(notes, "20 readings of 0 dBm (02:00:00:00:00:01) are not used")) << notes;
}

TEST(MapNotes, ReportThatNoRadioHasAPosition) {
  AccessPoint unplaced = test::accessPoint(1, 0.0, 0.0);
  unplaced.position_known = false;
  Mapper mapper(test::rawConfig(), {unplaced});
  for (int i = 0; i < 400; ++i) {
    mapper.insert(test::reading(i, lanes(i).x(), lanes(i).y(), -60.0));  // from anywhere
  }
  const std::vector<std::string> notes = textsOf(*mapper.infer());
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].rfind("no access point with readings has a position", 0), 0U) << notes[0];
}

TEST(MapNotes, IgnoreTheSignalsOfUnknownRadios) {
  Mapper mapper(test::rawConfig(), {test::accessPoint(1, 2.0, 1.5)});
  for (int i = 0; i < 400; ++i) {
    mapper.insert(test::reading(i, lanes(i).x(), lanes(i).y(), fading(lanes(i))));
    mapper.insert(test::reading(i, lanes(i).x(), lanes(i).y(), 0.0, 2));
  }
  EXPECT_EQ(textsOf(*mapper.infer()), std::vector<std::string>());
}

TEST(MapNotes, IgnoreAFewStrongReadings) {
  int reading = 0;
  const auto seldom_zero = [&](const Position& at) {
    return ++reading % 200 == 0 ? 0.0 : fading(at);
  };
  EXPECT_EQ(notesOf(lanes, seldom_zero, 400), "");
}

TEST(MapNotes, ReportStampsThatFitNoPose) {
  Mapper mapper(test::rawConfig(), {test::accessPoint(1, 2.0, 1.5)});
  for (int i = 0; i < 400; ++i) {
    const Position at = lanes(i * 163 % 400);  // each pose has the stamp of another one
    Reading reading = test::reading(0, at.x(), at.y(), fading(at));
    reading.stamp_ns = i * 200'000'000LL;
    mapper.insert(reading);
  }
  const std::vector<std::string> notes = textsOf(*mapper.infer());
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].rfind("half of the path's steps are faster than", 0), 0U) << notes[0];
}

TEST(MapNotes, ReportAnAccessPointAtAWrongPosition) {
  Mapper mapper(Config(), {test::accessPoint(1, 2.0, 1.5)});
  for (int i = 0; i < 400; ++i) {
    mapper.insert(test::reading(i, lanes(i).x(), lanes(i).y(), fading(lanes(i))));
  }
  const auto snapshot = mapper.infer();
  EXPECT_EQ(textsOf(*snapshot), std::vector<std::string>());
  AccessPointFit fit;
  fit.suspect = true;
  fit.distance_m = 3.25;
  fit.estimate.position = {5.0, 1.0};
  const DataFindings findings{{fit}, {}};
  EXPECT_EQ(textsOf(*snapshot, findings),
            std::vector<std::string>{
                "the readings of 1 access point fit another position much better than the given "
                "one: 02:00:00:00:00:01 (3.2 m away, at (5.0, 1.0)); measure the position again"});
  EXPECT_TRUE(isFault(mapNotes(*snapshot, findings)[0]));
}

TEST(MapNotes, ReportRoundedStamps) {
  Mapper mapper(test::rawConfig(), {test::accessPoint(1, 2.0, 1.5)});
  for (int i = 0; i < 400; ++i) {
    const Position at = lanes(i);
    mapper.insert(test::reading(i, at.x(), at.y(), fading(at)));
    mapper.insert(test::reading(i, at.x(), at.y(), fading(at) - 1.0));  // the same scan again
  }
  EXPECT_EQ(textsOf(*mapper.infer()), std::vector<std::string>());
  for (int i = 0; i < 3; ++i) {
    mapper.insert(test::reading(i, 0.1 * i + 0.05, 0.0, -90.0));
  }
  EXPECT_EQ(
      textsOf(*mapper.infer()),
      std::vector<std::string>{
          "3 readings are not used: the same radio has a stronger reading at the same stamp and "
          "another position; check whether stamps are rounded, such as to seconds"});
}

TEST(MapNotes, ReportASingleStamp) {
  Mapper mapper(test::rawConfig(), {test::accessPoint(1, 2.0, 1.5)});
  for (int i = 0; i < 400; ++i) {
    mapper.insert(test::reading(7, lanes(i).x(), lanes(i).y(), fading(lanes(i))));
  }
  const auto strongest = textsOf(*mapper.infer());
  ASSERT_EQ(strongest.size(), 1U) << strongest.back();
  EXPECT_EQ(strongest[0].rfind("all readings have the same stamp", 0), 0U) << strongest[0];
}

TEST(MapNotes, ReportAPathThatGoesOnElsewhere) {
  const auto jumping = [](int i) -> Position {
    return i < 200 ? lanes(i) : Position(lanes(i) + Position(20.0, 0.0));
  };
  const std::string notes = notesOf(jumping, fading, 400);
  EXPECT_TRUE(contain(notes, "path jumps 1 time, by up to 20 m, and goes on from there")) << notes;
}

TEST(MapNotes, ReportAnAccessPointWithSeveralLikelyPositions) {
  AccessPoint unplaced = test::accessPoint(1, 0.0, 0.0);
  unplaced.position_known = false;
  Mapper mapper(Config(), {unplaced});
  const Position beside(5.0, 3.0);  // or as far on the other side
  for (int i = 0; i < 200; ++i) {
    const Position at(0.05 * i, 0.0);
    mapper.insert(
        test::reading(i, at.x(), at.y(), -40.0 - 20.0 * std::log10((at - beside).norm())));
  }
  const auto snapshot = mapper.infer();
  ASSERT_TRUE(snapshot->access_points[0].estimate);
  ASSERT_TRUE(snapshot->access_points[0].estimate->ambiguous);
  const std::vector<std::string> straight = textsOf(*snapshot);  // another note says why
  ASSERT_EQ(straight.size(), 1U);
  EXPECT_EQ(straight[0].rfind("the path is straight", 0), 0U) << straight[0];
  Snapshot wide = *snapshot;
  wide.path.front().antenna_in_map.y() = 10.0;
  const std::vector<std::string> notes = textsOf(wide);
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.rfind("1 access point has several likely positions", 0) == 0;
  }));
}

TEST(MapNotes, ReportAMapBeyondOctoMap) {
  const auto far = [](int i) -> Position { return lanes(i) + Position(10000.0, 0.0); };
  const auto far_signal = [](const Position& at) {
    return fading(Position(at - Position(10000.0, 0.0)));
  };
  Mapper mapper(Config(), {test::accessPoint(1, 10002.0, 1.5)});
  for (int i = 0; i < 400; ++i) {
    mapper.insert(test::reading(i, far(i).x(), far(i).y(), far_signal(far(i))));
  }
  const std::vector<std::string> notes = textsOf(*mapper.infer());
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].rfind("there is no OctoMap", 0), 0U) << notes[0];
}

TEST(MapNotes, NameAccessPointsWithoutReading) {
  const Config config = test::rawConfig();
  Mapper mapper(config, {test::accessPoint(1, 2.0, 1.5), test::accessPoint(2, 3.0, 3.0),
                         test::accessPoint(3, 0.0, 0.0)});
  for (int i = 0; i < 400; ++i) {
    mapper.insert(test::reading(i, lanes(i).x(), lanes(i).y(), fading(lanes(i))));
  }
  EXPECT_EQ(textsOf(*mapper.infer()),
            std::vector<std::string>{"2 of 3 access points of the table have no reading: "
                                     "02:00:00:00:00:02, 02:00:00:00:00:03; compare the "
                                     "BSSIDs, or drive nearer"});
}

}  // namespace
}  // namespace sfw
