/// The paper read in other ways, and what then comes out.
#pragma once

#include "cases/paper/ledger/subject.hpp"
#include "reports/ledger.hpp"

namespace crawford::ledger {

/// One way to read the paper.
struct Reading {
    std::string name;
    std::vector<std::string> set = {};  ///< keys of the scene, as --set takes them
    bool of_rigid = false;              ///< whether it changes the rigid conductor as well
};

/// Of a pack and of a sandwich; the first is the one Crawford takes.
std::vector<Reading> pack_readings();
std::vector<Reading> sandwich_readings();

/// What a matrix burns.
std::vector<Scene> scenes_of(const Subject& subject, const Resolution& resolution,
                             const std::vector<Reading>& readings);

/// The matrices, from burns that are there.
reports::ReadingMatrix pack_matrix(const Resolution& resolution, const Request& request);
reports::ReadingMatrix sandwich_matrix(const Resolution& resolution, const Request& request);

}  // namespace crawford::ledger
