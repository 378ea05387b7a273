#include "scratch_tree.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "base/digest.hpp"
#include "base/process.hpp"

namespace crawford::mutants {

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    return {std::istreambuf_iterator<char>(in), {}};
}

void write(const fs::path& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    out << text;
    if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

std::vector<std::string> files_known_to_git(const fs::path& sources) {
    const auto listed = run_program(
        {"git", "-C", sources.string(), "ls-files", "--cached", "--others", "--exclude-standard"});
    if (listed.status != 0)
        throw std::runtime_error(sources.string() + " is no working tree of git");
    std::vector<std::string> files;
    std::istringstream lines(listed.output);
    for (std::string file; std::getline(lines, file);)
        if (fs::is_regular_file(sources / file)) files.push_back(file);
    return files;
}

}  // namespace

ScratchTree::ScratchTree(const fs::path& sources, fs::path copy) : copy_(std::move(copy)) {
    for (const std::string& file : files_known_to_git(sources)) mirror(sources / file, file);
    remove_strangers();
}

void ScratchTree::mirror(const fs::path& from, const std::string& file) {
    const std::string text = text_of(from);
    digests_[file] = digest(text);
    const fs::path to = copy_ / file;
    if (fs::exists(to) && text_of(to) == text) return;
    fs::create_directories(to.parent_path());
    write(to, text);
}

void ScratchTree::remove_strangers() const {
    std::vector<fs::path> strangers;
    for (const auto& entry : fs::recursive_directory_iterator(copy_))
        if (entry.is_regular_file() &&
            !digests_.contains(entry.path().lexically_relative(copy_).generic_string()))
            strangers.push_back(entry.path());
    for (const fs::path& stranger : strangers) fs::remove(stranger);
}

std::string ScratchTree::read(const std::string& file) const {
    return text_of(copy_ / file);
}

std::string ScratchTree::fingerprint(const std::function<bool(const std::string&)>& counts) const {
    std::string all;
    for (const auto& [file, digest_of_file] : digests_)
        if (counts(file)) all.append(file).append(" ").append(digest_of_file).append("\n");
    return digest(all);
}

std::vector<std::string> ScratchTree::studies() const {
    std::vector<std::string> names;
    for (const auto& [file, digest_of_file] : digests_)
        if (file.starts_with("cases/") && registers_studies(file)) names.push_back(study_of(file));
    std::ranges::sort(names);
    return names;
}

bool ScratchTree::registers_studies(const std::string& file) const {
    return file.ends_with(".cpp") && read(file).find(".studies =") != std::string::npos;
}

std::string study_of(const std::string& file) {
    std::string name = fs::path(file).stem().string();
    std::ranges::replace(name, '_', '-');
    return name;
}

ScratchTree::Planted::Planted(const ScratchTree& tree, const Fault& fault)
    : file_(tree.path() / fault.file), sound_(text_of(file_)) {
    write(file_, with_fault(sound_, fault));
}

// A file that cannot be written stays faulty only until the next run mirrors the sources anew.
ScratchTree::Planted::~Planted() {
    std::ofstream(file_, std::ios::binary) << sound_;
}

}  // namespace crawford::mutants
