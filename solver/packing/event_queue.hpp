/// When the next of many events happens.
#pragma once

#include <bit>
#include <cstddef>
#include <limits>
#include <vector>

namespace crawford {

/// The times of a fixed number of events, in a tournament: a time changes in log n steps. Of equal
/// times the event with the lowest number comes first.
class EventQueue {
public:
    /// `events` events, none of which ever happens.
    void reset(std::size_t events) {
        leaves_ = std::bit_ceil(events);
        times_.assign(leaves_, std::numeric_limits<double>::infinity());
        winners_.resize(2 * leaves_);
        for (std::size_t i = 0; i < leaves_; ++i) winners_[leaves_ + i] = i;
        for (std::size_t i = leaves_ - 1; i > 0; --i) winners_[i] = winners_[2 * i];
    }

    void set(std::size_t event, double time) {
        times_[event] = time;
        for (std::size_t i = (leaves_ + event) / 2; i > 0; i /= 2) {
            const std::size_t left = winners_[2 * i];
            const std::size_t right = winners_[2 * i + 1];
            winners_[i] = times_[right] < times_[left] ? right : left;
        }
    }

    std::size_t next() const { return winners_[1]; }
    double time(std::size_t event) const { return times_[event]; }

private:
    std::size_t leaves_ = 0;
    std::vector<double> times_;
    std::vector<std::size_t>
        winners_;  ///< of each match; the final at 1, the events from leaves_ on
};

}  // namespace crawford
