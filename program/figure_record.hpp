/// What a drawn case leaves: its record in DIR/records and, beside the pictures, its manifest.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cases/registry.hpp"
#include "reports/record_store.hpp"

namespace crawford {

/// The records of figures and of what the ledger rests on: known by all sources they are made of.
reports::RecordStore figure_records(const std::filesystem::path& out);

/// How a case is drawn: "draft", "paper" or "fine".
reports::Setting at_fidelity(const std::string& fidelity);
/// How it has been drawn.
std::string drawn_at(const reports::Record& record);

/// The record that the pictures of a case are of, if its last drawing has been done.
std::optional<reports::Record> drawn_record(reports::RecordStore& store, const std::string& name);

std::vector<Finding> findings_of(const reports::Record& record);
/// Puts what a case hands back into its record.
void fill(reports::Record& record, const Outcome& outcome);

/// `figures`/<name>_manifest.json.
std::filesystem::path manifest_of(const std::filesystem::path& figures, const std::string& name);

/// Files of the figure that are missing: those of numbers; pictures and manifest.
std::vector<std::filesystem::path> missing_data(const reports::Record& record,
                                                const std::filesystem::path& figures);
bool has_all_files(const reports::Record& record, const std::filesystem::path& figures);

/// Writes the manifest: where the figure comes from (`provenance`), then what the record says.
void write_manifest(const std::filesystem::path& figures, const reports::Record& record,
                    nlohmann::ordered_json provenance);

}  // namespace crawford
