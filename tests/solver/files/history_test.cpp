// The history of a restarted run is that of an unbroken one.
#include "solver/files/history.hpp"

#include "base/errors.hpp"
#include "tests/solver/scratch.hpp"

namespace crawford {

namespace {

class OutputHistory : public OutputTest {
protected:
    static HistoryRow row(int k) {
        return {k * 2e-5, 0.0045 / 3.0 * k, 900.0 / 7.0 * k, 0.1 * k,  1e-16 * k,       1.0 * k,
                0.07 * k, 1e8 / 3.0 * k,    5e7 * k,         0.01 * k, 300.0 / 7.0 * k, 0.3 * k,
                2e-5};
    }
    static void append(History& history, int first, int last) {
        for (int k = first; k <= last; ++k) history.append(row(k));
    }
    std::filesystem::path file() const { return directory / "history.csv"; }
};

TEST_F(OutputHistory, HasAHeaderWithUnitsAndEveryDigit) {
    History history = History::start(file());
    history.append({0.1 + 0.2, 1.0 / 3.0, 943.0901588633039, 0.5, 1e-300, 7, 0.25, 1.5e8, 1e8,
                    0.004, 299.5, 0.125, 2e-5});
    EXPECT_EQ(content(file()),
              "time [s],mean burn rate [m/s],max T [K],max strain [-],residual [-],"
              "solver iterations,strain within 5 um of max [-],max p [Pa],"
              "p within 5 um of max [Pa],regression rate [m/s],min T [K],max slope [-],"
              "step [s]\n"
              "0.30000000000000004,0.3333333333333333,943.0901588633039,0.5,1e-300,7,0.25,"
              "150000000,100000000,0.004,299.5,0.125,2e-05\n");
}

TEST_F(OutputHistory, ReadsAsUnbrokenAfterARestart) {
    History unbroken = History::start(directory / "unbroken.csv");
    append(unbroken, 1, 9);
    {
        History first = History::start(file());
        append(first, 1, 7);
    }
    std::ofstream(file(), std::ios::app) << "1.6e-04,0.00";  // killed while writing
    History second = History::resume(file(), row(4).time);
    append(second, 5, 9);
    EXPECT_EQ(content(file()), content(directory / "unbroken.csv"));
}

TEST_F(OutputHistory, KeepsAllWholeRowsWhereTheRestartIsLater) {
    {
        History first = History::start(file());
        append(first, 1, 3);
    }
    const std::string whole = content(file());
    std::ofstream(file(), std::ios::app) << "8e-05,0.00";
    History::resume(file(), 1.0);
    EXPECT_EQ(content(file()), whole);
}

TEST_F(OutputHistory, StartsWhereThereIsNone) {
    History::resume(file(), 1.0);
    EXPECT_TRUE(content(file()).starts_with("time [s],"));
}

TEST_F(OutputHistory, DoesNotTouchWhatIsNoHistory) {
    put(file(), "a letter\n");
    EXPECT_THROW(History::resume(file(), 1.0), InputError);
    EXPECT_EQ(content(file()), "a letter\n");
}

TEST_F(OutputHistory, ThatCannotBeWrittenIsRefused) {
    put(directory / "taken", "a file");
    EXPECT_THROW(History::start(directory / "taken" / "history.csv"), InputError);
}

}  // namespace

}  // namespace crawford
