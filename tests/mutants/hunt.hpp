/// The hunt for faults that nobody sees: each is put in, built, and shown to the judges in turn.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ledger.hpp"
#include "scratch_tree.hpp"
#include "workshop.hpp"

namespace crawford::mutants {

/// What became of one fault.
struct Verdict {
    struct Sighting {
        Judge judge;
        Finding finding;
    };

    Fault fault;
    std::vector<Sighting> heard;  ///< judges that looked, in that order
    std::string broken;           ///< why the row is worthless: does not apply, does not build

    bool survived() const;
    /// The first judge who saw it; none if it survived.
    const Sighting* killer() const;
    double seconds() const;  ///< that all its judges took
};

struct HuntOptions {
    std::vector<std::string> studies;  ///< those that judge
    bool all_studies = false;          ///< every judge looks, also when one has seen the fault
};

class Hunt {
public:
    Hunt(const ScratchTree& tree, const Workshop& workshop, Ledger& ledger, HuntOptions options);

    /// Lets every judge that these faults may need look at the sound sources, and keeps how long
    /// each takes: the limit of time for faulty ones rests on it.
    /// \throws std::runtime_error naming the gates that the sound sources fail, or if they do not
    /// build.
    void check_sound(const std::vector<Fault>& faults,
                     const std::function<void(const std::string&)>& say);

    Verdict judge(const Fault& fault);

private:
    std::vector<Judge> judges_of(const Fault& fault) const;
    std::string key(const Judge& judge, const Fault* fault) const;
    double limit(const Judge& judge) const;
    Finding look(const Judge& judge, const Fault& fault,
                 std::optional<ScratchTree::Planted>& planted);

    const ScratchTree& tree_;
    const Workshop& workshop_;
    Ledger& ledger_;
    HuntOptions options_;
};

}  // namespace crawford::mutants
