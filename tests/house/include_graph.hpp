/// Who includes whom in a tree of sources, and what of it is forbidden.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace crawford::house {

using Names = std::set<std::string>;

/// One directive of a file.
struct Include {
    std::string file;    ///< relative to the root of the tree
    std::string target;  ///< as it is written, with its quotes or brackets
};

/// What may be.
struct Rules {
    /// Top folders, and folders of them that may more, each with the folders that it may include.
    std::map<std::string, Names> may_know;
    /// Folders of solver/, lowest first; a folder may include those of lower ranks and itself.
    std::vector<Names> ranks;
    /// Top folders whose headers include Eigen, the standard library and ours only.
    Names lean;
    /// Headers of these that include another library all the same.
    Names wrappers;
};

inline std::string folder_of(const std::string& path) {
    return std::filesystem::path(path).parent_path().generic_string();
}

/// The first `count` parts of a path.
inline std::string top_of(const std::string& path, int count = 1) {
    std::string top;
    for (const auto& part : std::filesystem::path(path)) {
        if (count-- == 0) break;
        if (!top.empty()) top += '/';
        top += part.string();
    }
    return top;
}

/// The include directives of one file.
inline std::vector<Include> includes_of_file(const std::filesystem::path& root,
                                             const std::string& file) {
    static const std::regex directive(R"(^\s*(#|%:)\s*(include_next|include|import)\b\s*(.*)$)");
    std::vector<Include> found;
    std::ifstream lines(root / file);
    std::smatch match;
    for (std::string line; std::getline(lines, line);)
        if (line.size() < 500 && std::regex_match(line, match, directive))
            found.push_back({file, match[3]});
    return found;
}

/// All include directives of the folders that the rules name.
inline std::vector<Include> includes_of(const std::filesystem::path& root, const Rules& rules) {
    static const std::regex source(R"(.*\.(.pp|h|in))");
    std::vector<Include> found;
    for (const auto& [folder, known] : rules.may_know) {
        if (!std::filesystem::exists(root / folder)) continue;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
            const std::string file = entry.path().lexically_relative(root).generic_string();
            if (!entry.is_regular_file() || !std::regex_match(file, source)) continue;
            for (Include& include : includes_of_file(root, file)) found.push_back(include);
        }
    }
    return found;
}

/// The path between the quotes of a target, empty if it has none.
inline std::string quoted(const std::string& target) {
    const size_t end = target.find('"', 1);
    return target.starts_with('"') && end != std::string::npos ? target.substr(1, end - 1) : "";
}

/// The name between angle brackets, empty if there are none.
inline std::string bracketed(const std::string& target) {
    const size_t end = target.find('>');
    return target.starts_with('<') && end != std::string::npos ? target.substr(1, end - 1) : "";
}

/// The file of ours that an include brings in, empty for a library's.
inline std::string ours(const Include& include) {
    std::string path = quoted(include.target);
    if (path.empty() || path.find('/') != std::string::npos) return path;
    return folder_of(include.file) + '/' + path;
}

/// Of a folder of solver/; -1 if it has none.
inline int rank_of(const Rules& rules, const std::string& folder) {
    for (size_t k = 0; k < rules.ranks.size(); ++k)
        if (rules.ranks[k].contains(folder.substr(folder.find('/') + 1))) return int(k);
    return -1;
}

/// What is wrong with an include as it is written, empty if nothing is.
inline std::string wrong_spelling(const Include& include, const Rules& rules) {
    const std::string path = quoted(include.target);
    const std::string library = bracketed(include.target);
    if (path.empty() && library.empty()) return "is neither \"...\" nor <...>";
    if ((path + library).find("..") != std::string::npos) return "is relative";
    if (rules.may_know.contains(top_of(library))) return "has angle brackets around a file of ours";
    const bool beside = !path.empty() && path.find('/') == std::string::npos;
    return beside && top_of(include.file) != "tests" ? "names no folder" : "";
}

/// What is wrong with an include from one folder of solver/ to another, empty if nothing is.
inline std::string wrong_order(const std::string& from, const std::string& to, const Rules& rules) {
    if (from == to) return "";
    for (const std::string& folder : {from, to})
        if (rank_of(rules, folder) < 0) return folder + "/ has no rank";
    return rank_of(rules, to) < rank_of(rules, from) ? "" : from + "/ may not know " + to + "/";
}

/// What is wrong with where an include points, empty if nothing is.
inline std::string wrong_direction(const Include& include, const Rules& rules) {
    const std::string path = ours(include);
    if (path.empty()) return "";
    const std::string own = folder_of(include.file);
    const std::string from = rules.may_know.contains(own) ? own : top_of(include.file);
    const std::string to = top_of(path);
    if (!rules.may_know.at(from).contains(to)) return from + "/ may not know " + to + "/";
    return from == "solver" && to == "solver"
               ? wrong_order(top_of(include.file, 2), top_of(path, 2), rules)
               : "";
}

/// Whether a header brings in a library that its users should not need. The standard library's
/// headers have no dot and no folder.
inline bool is_heavy(const Include& include, const Rules& rules) {
    const std::string library = bracketed(include.target);
    return rules.lean.contains(top_of(include.file)) && include.file.ends_with(".hpp") &&
           library.find_first_of("/.") != std::string::npos && !library.starts_with("Eigen/");
}

/// Looks for a cycle among folders, depth first.
class CycleSearch {
public:
    explicit CycleSearch(const std::vector<Include>& includes) {
        for (const Include& include : includes) {
            const std::string to = folder_of(ours(include));
            const std::string from = folder_of(include.file);
            if (!to.empty() && to != from) graph_[from].insert(to);
        }
    }

    /// The first cycle, as "a -> b -> a"; empty if there is none.
    std::string cycle() {
        const auto graph = graph_;
        for (const auto& [folder, known] : graph)
            if (std::string found = from(folder); !found.empty()) return found;
        return "";
    }

private:
    std::string from(const std::string& folder) {
        if (const auto start = std::ranges::find(way_, folder); start != way_.end()) {
            std::string cycle;
            for (auto at = start; at != way_.end(); ++at) cycle += *at + " -> ";
            return cycle + folder;
        }
        if (finished_.contains(folder)) return "";
        way_.push_back(folder);
        for (const std::string& next : graph_[folder])
            if (std::string found = from(next); !found.empty()) return found;
        way_.pop_back();
        finished_.insert(folder);
        return "";
    }

    std::map<std::string, Names> graph_;
    std::vector<std::string> way_;
    Names finished_;
};

/// Everything that is wrong with a tree, a line each.
inline std::vector<std::string> complaints(const std::filesystem::path& root, const Rules& rules) {
    const std::vector<Include> includes = includes_of(root, rules);
    std::vector<std::string> found;
    Names wrapping;
    for (const Include& include : includes) {
        const auto complain = [&](const std::string& what) {
            if (!what.empty())
                found.push_back(include.file + ": #include " + include.target + ": " + what);
        };
        complain(wrong_spelling(include, rules));
        complain(wrong_direction(include, rules));
        if (!is_heavy(include, rules)) continue;
        wrapping.insert(include.file);
        if (!rules.wrappers.contains(include.file)) complain("users of this header need it too");
    }
    for (const std::string& wrapper : rules.wrappers)
        if (!wrapping.contains(wrapper))
            found.push_back(wrapper + " needs no leave any more: take it off the list of wrappers");
    if (const std::string cycle = CycleSearch(includes).cycle(); !cycle.empty())
        found.push_back("a cycle of folders: " + cycle);
    return found;
}

}  // namespace crawford::house
