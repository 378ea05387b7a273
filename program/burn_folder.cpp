#include "program/burn_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <vector>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "solver/files/scene_difference.hpp"

namespace crawford {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds between_beats{3};
/// A step takes seconds and a shared disk may hang for a while: ten times both.
constexpr std::chrono::minutes silence_of_the_dead{2};
constexpr auto owner_file = ".owner";
constexpr std::string_view history_ending = "_history.csv";

struct Owner {
    std::string host;
    long process = 0;
    std::string began;  ///< in ticks since the host did, from /proc: tells reused numbers apart
};

std::string host_name() {
    std::array<char, 256> name{};
    ::gethostname(name.data(), name.size() - 1);
    return name.data();
}

/// Empty if there is no such process, or no /proc. One that was killed and that nobody has waited for yet
/// (state Z) is none: it writes no more.
std::string beginning_of(long process) {
    std::ifstream file(fmt::format("/proc/{}/stat", process));
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const auto end_of_name = text.rfind(')');  // a name may hold blanks
    if (end_of_name == std::string::npos) return {};
    std::istringstream words(text.substr(end_of_name + 1));
    constexpr int fields_before = 19;  // state is the third of proc(5), starttime the 22nd
    std::string word;
    words >> word;
    if (word == "Z" || word == "X") return {};
    for (int k = 0; k < fields_before; ++k) words >> word;
    return word;
}

/// None if the file is gone or was cut short.
std::optional<Owner> read_owner(const fs::path& path) {
    std::ifstream file(path);
    Owner owner;
    if (!(file >> owner.host >> owner.process >> owner.began)) return {};
    return owner;
}

bool has_been_silent(const fs::path& path) {
    std::error_code gone;
    const auto touched = fs::last_write_time(path, gone);
    return gone || fs::file_time_type::clock::now() - touched > silence_of_the_dead;
}

bool is_alive(const std::optional<Owner>& owner, const fs::path& path) {
    if (!owner || owner->host != host_name()) return !has_been_silent(path);
    if (::kill(pid_t(owner->process), 0) != 0 && errno == ESRCH) return false;
    return beginning_of(owner->process) == owner->began;
}

/// Makes the file whole at once: a link fails where the name is taken.
bool make_exclusively(const fs::path& path) {
    const fs::path own = fmt::format("{}.{}.{}", path.string(), host_name(), ::getpid());
    write_file(own, fmt::format("{} {} {}\n", host_name(), ::getpid(), beginning_of(::getpid())));
    std::error_code taken;
    fs::create_hard_link(own, path, taken);
    fs::remove(own);
    if (taken && taken != std::errc::file_exists)
        throw InputError(fmt::format("cannot write {}: {}", path.string(), taken.message()));
    return !taken;
}

[[noreturn]] void refuse(const fs::path& folder, const std::optional<Owner>& owner) {
    const std::string who =
        owner ? fmt::format("process {} on {}", owner->process, owner->host) : "another run";
    throw InputError(fmt::format(
        "{} is being written into by {}; wait for it or name another --out", folder.string(), who));
}

bool is_of_name(const std::string& file, const std::string& name) {
    if (!file.starts_with(name)) return false;
    std::string rest = file.substr(name.size());
    if (rest == history_ending || rest == ".hdf.series") return true;
    if (rest.starts_with("_checkpoint")) rest.erase(0, std::strlen("_checkpoint"));
    const auto dot = rest.find('.');
    if (dot == std::string::npos || dot < 2 || rest.front() != '_') return false;
    const bool is_numbered = std::all_of(rest.begin() + 1, rest.begin() + long(dot),
                                         [](char c) { return c >= '0' && c <= '9'; });
    return is_numbered && (rest.substr(dot) == ".hdf" || rest.substr(dot) == ".h5");
}

/// What an owner that was killed has left half-written. Who asks for the folder now is let write its name:
/// what is left of a name goes when it has been silent.
void remove_halves_of_the_dead(const fs::path& folder) {
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string file = entry.path().filename().string();
        std::error_code gone;
        const bool is_a_name = file.starts_with("..owner") || file.starts_with(".owner.");
        const bool is_a_half = file.starts_with('.') && file.ends_with(".part");
        if (is_a_name ? has_been_silent(entry.path()) : is_a_half) fs::remove(entry.path(), gone);
    }
}

}  // namespace

BurnFolder::BurnFolder(const fs::path& folder)
    : file_(folder / owner_file), is_new_(!fs::exists(folder)) {
    prepare_directory(folder);
    while (!make_exclusively(file_)) {
        const auto owner = read_owner(file_);
        if (is_alive(owner, file_)) refuse(folder, owner);
        // Of two that take over, one renames: the other finds the new owner, or none.
        const fs::path dead = fmt::format("{}.dead.{}", file_.string(), ::getpid());
        std::error_code gone;
        fs::rename(file_, dead, gone);
        fs::remove(dead, gone);
    }
    remove_halves_of_the_dead(folder);
}

BurnFolder::~BurnFolder() {
    std::error_code gone;
    fs::remove(file_, gone);
    if (is_new_) fs::remove(file_.parent_path(), gone);  // fails where it holds anything
}

void BurnFolder::beat() {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_beat_ < between_beats) return;
    last_beat_ = now;
    std::error_code gone;
    fs::last_write_time(file_, fs::file_time_type::clock::now(), gone);
}

bool is_held(const fs::path& folder) {
    const fs::path file = folder / owner_file;
    return fs::exists(file) && is_alive(read_owner(file), file);
}

std::optional<KeptManifest> manifest_there(const fs::path& folder) {
    try {
        return kept_manifest(folder);
    } catch (const InputError& problem) {
        throw InputError(
            fmt::format("{}; name another --out, or remove what lies there", problem.what()));
    }
}

void refuse_results_of_others(const fs::path& folder, const Burning& burning, bool goes_on) {
    if (!fs::is_directory(folder)) return;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string file = entry.path().filename().string();
        if (!file.ends_with(history_ending) || file == burning.name + std::string(history_ending))
            continue;
        throw InputError(fmt::format(
            "{} holds the results of {}, not of {}; name another --out", folder.string(),
            file.substr(0, file.size() - history_ending.size()), burning.name));
    }
    const auto manifest = manifest_there(folder);
    if (!manifest) return;
    const auto key = difference(manifest->scene, burning.toml, "there");
    if (!key) return;
    const bool is_same_file =
        std::ranges::find(manifest->command, burning.scene.string()) != manifest->command.end();
    if (!goes_on && burning.folder_was_named && is_same_file) return;
    throw InputError(fmt::format("{} holds the results of another scene: {}; name another --out",
                                 folder.string(), *key));
}

void remove_results(const fs::path& folder, const std::string& name) {
    std::vector<fs::path> old;
    for (const auto& entry : fs::directory_iterator(folder))
        if (is_of_name(entry.path().filename().string(), name)) old.push_back(entry.path());
    if (fs::exists(folder / (name + std::string(history_ending))))
        old.push_back(folder / "manifest.json");
    for (const fs::path& file : old) fs::remove(file);
}

}  // namespace crawford
