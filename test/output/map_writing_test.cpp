#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <functional>
#include <set>
#include <system_error>

#include "files/atomic_file.h"
#include "structure_from_wifi/map_files.h"
#include "support/temporary_folder.h"

namespace sfw {
namespace {

/// A map of 400 x 400 cells, too much for the small disk below.
Snapshot snapshot(double x) {
  AccessPoint access_point;
  access_point.bssid = *Bssid::parse("02:00:00:00:00:01");
  access_point.position = {x, 0.0};
  Grid<float> occupied(GridGeometry(0.05, {-10.0, -10.0}, 400, 400), 0.5F);
  occupied[occupied.geometry.cellAt(access_point.position)] = 0.1F;
  return {BeliefMap(occupied, {}),
          BeliefMap(occupied, {}),
          {},
          {{access_point, 0, WallCountClusters{}}},
          {}};
}

class MapWriting : public test::TemporaryFolder {
 protected:
  /// What writing complains of.
  static std::string complaintOf(const std::function<void()>& action) {
    try {
      action();
    } catch (const std::system_error& error) {
      return error.what();
    }
    return "nothing";
  }

  /// Names and bytes of all files in a directory.
  static std::set<std::pair<std::string, std::string>> contentOf(
      const std::filesystem::path& directory) {
    std::set<std::pair<std::string, std::string>> files;
    for (const auto& entry : std::filesystem::directory_iterator(directory)) {
      std::ifstream stream(entry.path(), std::ios::binary);
      files.emplace(
          entry.path().filename().string(),
          entry.is_directory() ? "" : std::string(std::istreambuf_iterator<char>(stream), {}));
    }
    return files;
  }
};

const std::set<std::string> kFiles{
    "map.pgm",     "map.yaml",   "probability.pgm", "probability.png", "probability.yaml",
    "costs.png",   "costs.yaml", "map.bt",          "map.ot",          "map.png",
    "report.json", "walls.yaml", "walls.svg",       "walls.dxf"};

TEST_F(MapWriting, MakesItsDirectoryAndAllFiles) {
  writeMapFiles(snapshot(0), Config(), path("new/directory"));
  std::set<std::string> names;
  for (const auto& [name, bytes] : contentOf(path("new/directory"))) {
    names.insert(name);
    EXPECT_FALSE(bytes.empty()) << name;
  }
  EXPECT_EQ(names, kFiles);
}

TEST_F(MapWriting, LeavesNoOctoMapOfAnEarlierMapWhereItHasNone) {
  writeMapFiles(snapshot(0), Config(), folder_.string());
  write("notes.txt", "precious");
  Snapshot far = snapshot(0);
  far.belief = BeliefMap(Grid<float>(GridGeometry(0.05, {10000.0, 0.0}, 40, 40), 0.1F), {});
  writeMapFiles(far, Config(), folder_.string());
  std::set<std::string> expected = kFiles;
  expected.erase("map.bt");
  expected.erase("map.ot");
  expected.insert("notes.txt");
  std::set<std::string> names;
  for (const auto& [name, bytes] : contentOf(folder_)) {
    names.insert(name);
  }
  EXPECT_EQ(names, expected);
}

TEST_F(MapWriting, WritesFilesThatOthersMayRead) {
  writeAtomically(path("file"), "text");
  using std::filesystem::perms;
  const perms permissions = std::filesystem::status(path("file")).permissions();
  EXPECT_NE(permissions & perms::owner_read, perms::none);
  EXPECT_NE(permissions & perms::owner_write, perms::none);
  const mode_t mask = umask(0);
  umask(mask);
  EXPECT_EQ((permissions & perms::others_read) != perms::none, (mask & 0004) == 0);
}

TEST_F(MapWriting, ReplacesAnOldMapAndRepeatsItself) {
  writeMapFiles(snapshot(0), Config(), folder_.string());
  const auto first = contentOf(folder_);
  writeMapFiles(snapshot(3), Config(), folder_.string());
  EXPECT_NE(contentOf(folder_), first);
  writeMapFiles(snapshot(0), Config(), folder_.string());
  EXPECT_EQ(contentOf(folder_), first);
}

TEST_F(MapWriting, NamesAFileInTheDirectorysWay) {
  write("file", "precious");
  for (const std::string& directory : {path("file"), path("file/below")}) {
    const std::string complaint =
        complaintOf([&] { writeMapFiles(snapshot(0), Config(), directory); });
    EXPECT_EQ(complaint.rfind(path("file"), 0), 0U) << complaint;
  }
  EXPECT_EQ(read("file"), "precious");
}

TEST_F(MapWriting, RefusesADirectoryWithoutAName) {
  EXPECT_NE(complaintOf([] { writeMapFiles(snapshot(0), Config(), ""); }), "nothing");
  EXPECT_NE(complaintOf([&] { writeMapFiles(snapshot(0), Config(), path(std::string(300, 'a'))); }),
            "nothing");
}

TEST_F(MapWriting, LeavesTheOldMapIfADirectoryIsInAFilesWay) {
  writeMapFiles(snapshot(0), Config(), folder_.string());
  std::filesystem::remove(path("map.png"));
  std::filesystem::create_directories(path("map.png/below"));
  const auto before = contentOf(folder_);
  const std::string complaint =
      complaintOf([&] { writeMapFiles(snapshot(3), Config(), folder_.string()); });
  EXPECT_EQ(complaint.rfind(path("map.png") + ": cannot be written", 0), 0U) << complaint;
  EXPECT_EQ(contentOf(folder_), before);
}

/// Runs as nobody if it was root, who may write anywhere.
class WithoutPrivileges {
 public:
  WithoutPrivileges() : was_root_(geteuid() == 0) {
    constexpr uid_t kNobody = 65534;
    dropped_ = !was_root_ || seteuid(kNobody) == 0;
  }
  WithoutPrivileges(const WithoutPrivileges&) = delete;
  WithoutPrivileges& operator=(const WithoutPrivileges&) = delete;
  ~WithoutPrivileges() {
    if (was_root_ && seteuid(0) != 0) {
      ADD_FAILURE() << "privileges did not come back";
    }
  }
  bool dropped() const { return dropped_; }

 private:
  bool was_root_;
  bool dropped_ = false;
};

TEST_F(MapWriting, LeavesTheOldMapIfTheDirectoryIsReadOnly) {
  writeMapFiles(snapshot(0), Config(), folder_.string());
  const auto before = contentOf(folder_);
  chmod(folder_.c_str(), 0555);
  std::string complaint;
  {
    const WithoutPrivileges nobody;
    if (!nobody.dropped()) {
      GTEST_SKIP() << "this root cannot drop its privileges";
    }
    complaint = complaintOf([&] { writeMapFiles(snapshot(3), Config(), folder_.string()); });
  }
  chmod(folder_.c_str(), 0755);
  EXPECT_EQ(complaint.rfind(path("map.pgm") + ": cannot be written", 0), 0U) << complaint;
  EXPECT_EQ(contentOf(folder_), before);
}

/// A disk of its own at a directory, unmounted afterwards.
class SmallDisk {
 public:
  SmallDisk(const std::string& directory, const char* options)
      : directory_(directory),
        mounted_(mount("tmpfs", directory.c_str(), "tmpfs", 0, options) == 0) {}
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    if (mounted_) {
      umount(directory_.c_str());
    }
  }
  bool mounted() const { return mounted_; }

 private:
  std::string directory_;
  bool mounted_;
};

TEST_F(MapWriting, LeavesTheOldMapIfTheDiskIsFull) {
  const std::string directory = path("disk");
  std::filesystem::create_directories(directory);
  // One map takes 350 kB: the first fits, a second beside it does not.
  const SmallDisk disk(directory, "size=512k");
  if (!disk.mounted()) {
    GTEST_SKIP() << "mounting a small disk takes privileges";
  }
  writeMapFiles(snapshot(0), Config(), directory);
  const auto before = contentOf(directory);
  const std::string complaint =
      complaintOf([&] { writeMapFiles(snapshot(3), Config(), directory); });
  EXPECT_EQ(complaint.rfind(directory + "/", 0), 0U) << complaint;
  EXPECT_NE(complaint.find("No space left"), std::string::npos) << complaint;
  EXPECT_EQ(contentOf(directory), before);
}

}  // namespace
}  // namespace sfw
