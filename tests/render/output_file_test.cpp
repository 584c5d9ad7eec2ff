// SPDX-License-Identifier: MIT
#include "occlude/render/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "occlude/render/errors.h"

namespace occlude::render {
namespace output_file_test {

namespace fs = std::filesystem;

class OutputFileTest : public testing::Test {
 protected:
  OutputFileTest() { fs::create_directories(folder_); }
  ~OutputFileTest() override { fs::remove_all(folder_); }

  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  [[nodiscard]] static std::string content(const fs::path& file) {
    std::ostringstream out;
    out << std::ifstream(file, std::ios::binary).rdbuf();
    return out.str();
  }
  [[nodiscard]] static std::string failure(const fs::path& file) {
    try {
      OutputFile output(file);
      output.commit();
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path folder_ = fs::temp_directory_path() / ("occlude_output_file_" + std::to_string(getpid()));
};

TEST_F(OutputFileTest, AppearsOnlyOnCommit) {
  const fs::path file = folder_ / "a.txt";
  OutputFile output(file);
  output.write("hello ");
  output.write("7");
  EXPECT_FALSE(fs::exists(file));
  EXPECT_LE(files(), 1U);  // the temporary one, where files must have names
  output.commit();
  EXPECT_EQ(content(file), "hello 7");
  EXPECT_EQ(files(), 1U);
}

TEST_F(OutputFileTest, LeavesNothingOfAKilledProcess) {
  const int tried = open(folder_.c_str(), O_WRONLY | O_TMPFILE, 0666);
  if (tried < 0) GTEST_SKIP() << "the file system has no files without names";
  close(tried);
  const pid_t child = fork();
  if (child == 0) {
    OutputFile output(folder_ / "a.txt");
    output.write(std::string(1U << 20U, 'x'));
    raise(SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
  EXPECT_EQ(files(), 0U);
}

TEST_F(OutputFileTest, KeepsPermissionsAndWritesOverWhatIsThere) {
  const fs::path file = folder_ / "a.txt";
  std::ofstream(file) << "old";
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  OutputFile output(file);
  output.write("new");
  output.close();
  EXPECT_EQ(content(file), "old");
  output.commit();
  EXPECT_EQ(content(file), "new");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(files(), 1U);
}

TEST_F(OutputFileTest, VanishesWithoutCommitAndLeavesTheOldFile) {
  const fs::path file = folder_ / "a.txt";
  std::ofstream(file) << "old";
  {
    OutputFile output(file);
    output.write("new");
  }
  EXPECT_EQ(content(file), "old");
  EXPECT_EQ(files(), 1U);
}

TEST_F(OutputFileTest, NamesAFileThatCannotBeCreated) {
  const std::string missing = (folder_ / "no" / "a.txt").string();
  EXPECT_EQ(failure(missing), missing + ": cannot create: No such file or directory");
  EXPECT_EQ(failure(folder_), folder_.string() + ": cannot create: Is a directory");
  EXPECT_EQ(files(), 0U);
}

TEST_F(OutputFileTest, NamesAFolderThatCannotBeWritten) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  const std::string file = (folder_ / "a.txt").string();
  EXPECT_EQ(failure(file), file + ": cannot create: Permission denied");
  fs::permissions(folder_, fs::perms::owner_all);
}

TEST_F(OutputFileTest, ReportsAFullDisk) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this system";
  const fs::file_type type = fs::status("/dev/full").type();
  try {
    OutputFile output("/dev/full");
    output.write("more than nothing");
    output.commit();
    FAIL() << "wrote to a full device";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), std::string("/dev/full: cannot write: No space left on device"));
  }
  EXPECT_EQ(fs::status("/dev/full").type(), type);  // a device is written, never replaced
}

}  // namespace output_file_test
}  // namespace occlude::render
