// SPDX-License-Identifier: MIT
// Parts are dealt to whoever asks, results come in order, and what was kept is used again, or refused.
#include "occlude/render/job.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "dealer.h"
#include "kept_parts.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/packing.h"
#include "seal.h"

namespace occlude::render {
namespace job_test {

namespace fs = std::filesystem;

/// Doubles the numbers from 0 to 99.
struct Doubling {
  int begun = 0, worked = 0;
  std::vector<int> results;
  int last = 99;

  [[nodiscard]] Stage stage() {
    return {[this] { return begun > last ? std::nullopt : std::optional(std::to_string(begun++)); },
            [this](const std::string& input) {
              ++worked;
              return std::to_string(2 * std::stoi(input));
            },
            [this](const std::string& result) { results.push_back(std::stoi(result)); }};
  }
  void expect_all() const {
    ASSERT_EQ(results.size(), 100U);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(results[static_cast<std::size_t>(i)], 2 * i);
  }
};

void write(const fs::path& file, const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }

/// A user with a folder for state and no key yet.
class Home {
 public:
  Home() {
    fs::create_directory(folder_);
    setenv("XDG_STATE_HOME", state().c_str(), 1);
  }
  ~Home() { fs::remove_all(folder_); }
  Home(const Home&) = delete;
  Home& operator=(const Home&) = delete;

  [[nodiscard]] const fs::path& folder() const { return folder_; }
  [[nodiscard]] fs::path state() const { return folder_ / "state"; }
  [[nodiscard]] fs::path key() const { return state() / "occlude/parts.key"; }

 private:
  fs::path folder_ = testing::TempDir() + "/occlude_home_" + std::to_string(getpid());
};

class KeptJob : public testing::Test {
 protected:
  KeptJob() { fs::create_directory(folder_); }
  ~KeptJob() override { fs::remove_all(folder_); }

  /// Works until `parts` more are done, and dies of an `End`.
  template <class End>
  void end_after(int parts, const End& end, bool resume = false) {
    Doubling doubling;
    Stage stage = doubling.stage();
    stage.work = [&, work = stage.work](const std::string& input) {
      if (doubling.worked == parts) throw end;
      return work(input);
    };
    Job job({.folder = parts_, .resume = resume}, [] { return 1; });
    EXPECT_THROW(job.run(stage), End);
  }
  void die_after(int parts) { end_after(parts, std::runtime_error("died")); }
  /// What a job says that is interrupted after so many more parts.
  std::string said_after(int parts, bool resume) {
    testing::internal::CaptureStderr();
    end_after(parts, Interrupted(), resume);
    return testing::internal::GetCapturedStderr();
  }
  [[nodiscard]] std::string refusal(std::uint64_t key, bool resume) const {
    try {
      const Job job({.folder = parts_, .resume = resume}, [&] { return key; });
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  const std::string folder_ = testing::TempDir() + "/occlude_job_" + std::to_string(getpid());
  const std::string parts_ = folder_ + "/parts";
  const std::string part_ = parts_ + "/part-0-000000";
  const Home home_;
};

TEST(Job, TakesResultsInTheOrderOfTheParts) {
  Doubling doubling;
  Job job({}, [] { return 0; });
  job.run(doubling.stage());
  doubling.expect_all();
  EXPECT_EQ(doubling.worked, 100);
}

TEST(Job, ThrowsWhatAPartThrows) {
  Doubling doubling;
  Stage stage = doubling.stage();
  stage.work = [](const std::string& input) { return input == "3" ? throw std::runtime_error("three") : std::string("0"); };
  Job job({}, [] { return 0; });
  EXPECT_THROW(job.run(stage), std::runtime_error);
  EXPECT_EQ(doubling.results.size(), 3U);
}

TEST(Dealer, PutsResultsInOrderThatComeInAnother) {
  Doubling doubling;
  const Stage stage = doubling.stage();
  Dealer dealer(stage, 0, nullptr);
  const auto first = dealer.next(), second = dealer.next();
  dealer.accept(second->number, "2", 0);
  EXPECT_TRUE(doubling.results.empty());
  dealer.accept(first->number, "0", 1);
  EXPECT_EQ(doubling.results, (std::vector{0, 2}));
}

TEST(Dealer, ServesManyThreads) {
  Doubling doubling;
  const Stage stage = doubling.stage();
  Dealer dealer(stage, 0, nullptr);
  const auto work = [&] {
    while (const auto part = dealer.next()) dealer.accept(part->number, std::to_string(2 * std::stoi(part->input)), 0);
  };
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t) threads.emplace_back(work);
  }
  dealer.finish();
  doubling.expect_all();
}

TEST(Dealer, DealsNothingAfterAFailure) {
  Doubling doubling;
  const Stage stage = doubling.stage();
  Dealer dealer(stage, 0, nullptr);
  ASSERT_TRUE(dealer.next());
  dealer.fail(std::make_exception_ptr(std::runtime_error("first")));
  EXPECT_FALSE(dealer.next());
  EXPECT_THROW(dealer.finish(), std::runtime_error);
}

/// What the dealer fails with.
std::string failure(Dealer& dealer) {
  try {
    dealer.finish();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// One part, whose result must be "right".
Stage one_part(bool& is_begun) {
  return {[&] { return std::exchange(is_begun, true) ? std::nullopt : std::optional<std::string>("input"); },
          [](const std::string&) { return "right"; },
          [](const std::string& result) { require_part(result == "right", "it is not right"); }};
}

TEST(Dealer, SaysWhoseResultIsWrong) {
  bool is_begun = false;
  const Stage stage = one_part(is_begun);
  Dealer dealer(stage, 0, nullptr);
  dealer.accept(dealer.next()->number, "wrong", 3);
  EXPECT_EQ(failure(dealer), "rank 3: not the result of this part: it is not right");
}

TEST(Dealer, RefusesAResultThatIsNotAwaited) {
  for (const bool is_known : {false, true}) {
    bool is_begun = false;
    const Stage stage = one_part(is_begun);
    Dealer dealer(stage, 0, nullptr);
    const auto part = dealer.next();
    if (is_known) dealer.accept(part->number, "right", 1);
    dealer.accept(is_known ? part->number : part->number + 1, "right", 1);
    EXPECT_EQ(failure(dealer), "rank 1: a result of a part that it was not given");
  }
}

/// Wherever a part is from, what it says is held against what it was to do.
TEST_F(KeptJob, NamesThePartThatIsWrong) {
  KeptParts kept(parts_, 1, false);
  kept.keep({0, 0}, "input", "wrong");
  bool is_begun = false;
  const Stage stage = one_part(is_begun);
  Dealer dealer(stage, 0, &kept);
  EXPECT_FALSE(dealer.next());
  EXPECT_EQ(failure(dealer), parts_ + "/part-0-000000: not the result of this part: it is not right");
}

TEST_F(KeptJob, RefusesFilesThatAreNoParts) {
  KeptParts kept(parts_, 1, false);
  kept.keep({0, 0}, "input", "result");
  const fs::path file = part_;
  const auto refusal = [&] {
    try {
      (void)kept.find({0, 0}, "input");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  fs::resize_file(file, std::uintmax_t{3} << 30U);
  EXPECT_EQ(refusal(), file.string() + ": cannot read: it is larger than 256 MiB");
  fs::remove(file);
  fs::create_directory(file);
  EXPECT_EQ(refusal(), file.string() + ": cannot read: it is a directory");
  fs::remove(file);
  fs::create_symlink("/dev/zero", file);
  EXPECT_EQ(refusal(), file.string() + ": cannot read: it is not a regular file");
  fs::remove(file);
  fs::create_symlink("nothing", file);
  EXPECT_EQ(refusal(), file.string() + ": cannot read: No such file or directory");
}

TEST_F(KeptJob, GoesOnWithWhatIsFinished) {
  die_after(40);
  Doubling doubling;
  {
    Job job({.folder = parts_, .resume = true}, [] { return 1; });
    job.run(doubling.stage());
    EXPECT_EQ(doubling.worked, 60);
    job.finish();
  }
  doubling.expect_all();
  EXPECT_FALSE(fs::exists(parts_));
}

TEST_F(KeptJob, RefusesPartsOfAnotherJob) {
  die_after(1);
  EXPECT_EQ(refusal(1, true), "");
  const std::string refused = parts_ + ": has parts of another run: another user, other options, input or program";
  EXPECT_EQ(refusal(2, true), refused);
  EXPECT_EQ(refusal(1, false), parts_ + ": has finished parts of an earlier run; go on with --resume, or remove the folder");
  setenv("XDG_STATE_HOME", (folder_ + "/another").c_str(), 1);
  EXPECT_EQ(refusal(1, true), refused);
}

TEST_F(KeptJob, RefusesToGoOnWithNothing) {
  EXPECT_EQ(refusal(1, true), parts_ + ": has no parts of an earlier run, so --resume cannot go on");
}

TEST_F(KeptJob, SaysWhatItHasKept) {
  EXPECT_EQ(said_after(0, false), "") << "--resume has nothing to go on with";
  EXPECT_FALSE(fs::exists(parts_));
  const std::string line = "occlude: 2 finished parts are in " + parts_ + ": --resume goes on\n";
  EXPECT_EQ(said_after(2, false), line);
  EXPECT_EQ(said_after(0, true), line) << "interrupted once more, before it has done anything";
}

TEST_F(KeptJob, LeavesNoFolderWithoutParts) {
  die_after(0);
  EXPECT_FALSE(fs::exists(parts_));
}

TEST_F(KeptJob, FindsPartsOfTheSameInput) {
  KeptParts kept(parts_, 1, false);
  kept.keep({0, 0}, "input", "result");
  EXPECT_EQ(kept.find({0, 0}, "input"), "result");
  EXPECT_FALSE(kept.find({0, 1}, "input"));
  EXPECT_FALSE(kept.find({1, 0}, "input"));
  EXPECT_FALSE(kept.find({0, 0}, "other"));
  write(part_, "");
  EXPECT_FALSE(kept.find({0, 0}, "input"));
}

TEST_F(KeptJob, RefusesPartsThatNoRunHasKeptSo) {
  {
    KeptParts kept(parts_, 1, false);
    for (const std::uint64_t part : {0, 1}) kept.keep({0, part}, "input", "result");
    kept.keep({1, 0}, "input", "result");
    EXPECT_EQ(read_input(part_).size(), 64U + 1 + 64 + 1 + 6);  // two seals, and the result
  }
  const std::string honest = read_input(part_);
  const auto refusal = [&](std::uint64_t key = 1) {
    fs::remove(parts_ + "/job");
    KeptParts kept(parts_, key, false);
    try {
      return kept.find({0, 0}, "input").value_or("none");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  const std::string refused = part_ + ": not as a run of yours has kept it; remove it, and --resume makes it again";
  EXPECT_EQ(refusal(), "result");
  EXPECT_EQ(refusal(2), refused) << "of another job";
  for (std::size_t i = 65; i < honest.size(); ++i) {
    std::string changed = honest;
    changed[i] ^= 1;
    write(part_, changed);
    EXPECT_EQ(refusal(), refused) << "byte " << i;
  }
  write(part_, honest + "x");
  EXPECT_EQ(refusal(), refused);
  for (const char* const other : {"/part-0-000001", "/part-1-000000"}) {
    write(part_, read_input(parts_ + other));
    EXPECT_EQ(refusal(), refused) << "that of" << other;
  }
  fs::remove(parts_ + "/job");
  KeptParts(parts_, 1, false).keep({0, 0}, "other", "result");
  write(part_, honest.substr(0, 64) + read_input(part_).substr(64));
  EXPECT_EQ(refusal(), refused) << "of another input";
  write(part_, honest);
  EXPECT_EQ(refusal(), "result");
}

TEST(Seal, DependsOnWhereTextsAreDivided) {
  const Home home;
  const Seal seal;
  EXPECT_EQ(seal.of({"ab", "c"}), seal.of({"ab", "c"}));
  EXPECT_NE(seal.of({"ab", "c"}), seal.of({"a", "bc"}));
  EXPECT_NE(seal.of({"ab", ""}), seal.of({"ab"}));
  EXPECT_EQ(seal.of({"ab"}), Seal().of({"ab"})) << "the key is made once";
  fs::remove_all(home.state());
  EXPECT_NE(seal.of({"ab"}), Seal().of({"ab"})) << "each key is another";
}

/// The code can be made by whoever has the key, by any BLAKE2b: fuzz/hostile/parts.py does.
TEST(Seal, IsBlake2b) {
  const Home home;
  (void)Seal();
  write(home.key(), std::string(32, 'k'));
  // Python: hashlib.blake2b(b"%016xab" % 2, key=b"k" * 32, digest_size=32).hexdigest()
  EXPECT_EQ(Seal().of({"ab"}), "5dba07df99b192573e5e899c56214ba1e2284f50051a19d4dc11af856836b67b");
}

TEST(Seal, StandsInTheFoldersOfTheSpecification) {
  const Home home;
  (void)Seal();
  EXPECT_EQ(fs::status(home.key()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(fs::file_size(home.key()), 32U);
  EXPECT_TRUE(fs::equivalent(*fs::directory_iterator(home.key().parent_path()), home.key())) << "nothing beside it";
  for (const char* const none : {"", "not/a/full/path"}) {
    setenv("XDG_STATE_HOME", none, 1);
    setenv("HOME", home.folder().c_str(), 1);
    (void)Seal();
    EXPECT_TRUE(fs::exists(home.folder() / ".local/state/occlude/parts.key"));
    fs::remove_all(home.folder() / ".local");
  }
}

TEST(Seal, RefusesAKeyThatIsNotTheUsersAlone) {
  const Home home;
  const std::string name = home.key().string() + ": the key that seals parts: ";
  const std::string advice = "; XDG_STATE_HOME may name another folder";
  const auto refusal = [] {
    try {
      (void)Seal();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(refusal(), "none");
  for (const fs::perms others :
       {fs::perms::group_read, fs::perms::others_read, fs::perms::group_write, fs::perms::others_write}) {
    fs::permissions(home.key(), others, fs::perm_options::add);
    EXPECT_EQ(refusal(), name + "others can read or write it" + advice);
    fs::permissions(home.key(), others, fs::perm_options::remove);
  }
  write(home.key(), "short");
  EXPECT_EQ(refusal(), name + "it has 5 bytes, not 32" + advice);
  fs::remove(home.key());
  fs::create_symlink("nothing", home.key());
  EXPECT_EQ(refusal(), name + "cannot read: No such file or directory" + advice);
  fs::remove_all(home.state());
  write(home.state(), "");
  EXPECT_EQ(refusal(), name + "cannot create: Not a directory" + advice);
}

TEST(Packing, ReadsBackWhatItWrote) {
  const std::vector<bool> bits{true, false, true, true, false, false, false, true, true};
  const std::string bytes =
      Packer().put(7).put(std::string("a\0b", 3)).put(std::vector{1.5, -2.0}).put(bits).put(std::vector<bool>{}).bytes();
  Unpacker unpacker(bytes);
  EXPECT_EQ(unpacker.get<int>(), 7);
  EXPECT_EQ(unpacker.text(), std::string("a\0b", 3));
  EXPECT_EQ(unpacker.list<double>(), (std::vector{1.5, -2.0}));
  EXPECT_EQ(unpacker.bits(), bits);
  EXPECT_TRUE(unpacker.bits().empty());
  EXPECT_TRUE(unpacker.is_empty());
  unpacker.finish();
  EXPECT_THROW((void)unpacker.get<char>(), PartError);
}

/// What reading these bytes throws.
template <class Read>
std::string refusal_of(const std::string& bytes, Read&& read) {
  Unpacker unpacker(bytes);
  try {
    read(unpacker);
  } catch (const PartError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Packing, RefusesWhatNobodyPacked) {
  const auto bits = [](Unpacker& unpacker) { (void)unpacker.bits(); };
  const auto list = [](Unpacker& unpacker) { (void)unpacker.list<double>(); };
  const auto text = [](Unpacker& unpacker) { (void)unpacker.text(); };
  const auto flag = [](Unpacker& unpacker) { (void)unpacker.flag(); };
  // Nothing of this size is allocated.
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  for (const std::uint64_t size : {kMost, kMost - 7, kMost / 2, std::uint64_t{9}}) {
    EXPECT_EQ(refusal_of(Packer().put(size).put(std::string("x")).bytes(), bits), "flags are not as many as it says");
    EXPECT_EQ(refusal_of(Packer().put(size).put('x').bytes(), text), "it ends too early");
    EXPECT_EQ(refusal_of(Packer().put(size).put('x').bytes(), list), "it ends too early");
  }
  EXPECT_EQ(refusal_of(Packer().put(std::string(9, 'x')).bytes(), list), "a list ends within a value");
  EXPECT_EQ(refusal_of("\2", flag), "a flag is neither 0 nor 1");
  EXPECT_EQ(refusal_of("\1x", [](Unpacker& unpacker) { (void)unpacker.flag(), unpacker.finish(); }),
            "it goes on where it should end");
}

}  // namespace job_test
}  // namespace occlude::render
