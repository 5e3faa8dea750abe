// SPDX-License-Identifier: GPL-2.0-or-later
//
// liggghts-plastigran: stock LIGGGHTS with the contact laws of libplastigran loaded. Same command
// line as `liggghts`; one check more: a `-var` the deck never mentions is a misspelling, not a no-op.
#include <mpi.h>
#include <signal.h>

#include <cctype>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "input.h"
#include "lammps.h"
#include "signal_handling.h"

namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

bool mentions(const std::string& text, const std::string& name) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool starts = at == 0 || !is_word(text[at - 1]) ||
                        (at > 1 && text[at - 1] == '_' && text[at - 2] == 'v');  // v_name
    if (starts && (end == text.size() || !is_word(text[end]))) return true;
  }
  return false;
}

// What the deck lets one set: its `variable NAME index DEFAULT` lines. Comments are dropped from
// `text`; `complete` turns false when the deck reads further files, which may use any variable.
std::vector<std::string> settings(std::istream& deck, std::string& text, bool& complete) {
  std::vector<std::string> names;
  for (std::string line; std::getline(deck, line);) {
    line = line.substr(0, line.find('#'));
    text += line + '\n';
    std::istringstream words(line);
    std::string command, name, style;
    words >> command >> name >> style;
    if (command == "variable" && style == "index") names.push_back(name);
    if (command == "include" || command == "jump") complete = false;
  }
  return names;
}

// The complaint about a -var that the deck does not know, or an empty string.
std::string unknown_variable(const std::string& path, const std::set<std::string>& given) {
  std::ifstream deck(path);
  if (!deck) return {};  // the engine says it better
  std::string text;
  bool complete = true;
  const std::vector<std::string> names = settings(deck, text, complete);
  for (const std::string& name : given) {
    if (mentions(text, name)) continue;
    // A deck that declares settings declares all of them, whatever else it includes.
    if (!complete && names.empty()) continue;
    std::string message = "-var " + name + ": " + path + " has no such variable";
    if (!names.empty()) message += "; it takes";
    for (const std::string& known : names) message += " " + known;
    return message;
  }
  return {};
}

std::string check_command_line(int argc, char** argv) {
  std::string path;
  std::set<std::string> given;
  for (int i = 1; i + 1 < argc; ++i) {
    if (!std::strcmp(argv[i], "-in") || !std::strcmp(argv[i], "-i")) path = argv[++i];
    else if (!std::strcmp(argv[i], "-var") || !std::strcmp(argv[i], "-v")) given.insert(argv[++i]);
  }
  return path.empty() ? std::string() : unknown_variable(path, given);
}

}  // namespace

int main(int argc, char** argv) {
  struct sigaction action;
  std::memset(&action, 0, sizeof action);
  action.sa_handler = LAMMPS_NS::SignalHandler::int_handler;  // finish the step, write what is due
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  action.sa_handler = LAMMPS_NS::SignalHandler::usr1_handler;
  sigaction(SIGUSR1, &action, nullptr);

  // One rank's error ends in MPI_Abort, which would take the buffered message with it.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  MPI_Init(&argc, &argv);
  const std::string complaint = check_command_line(argc, argv);
  if (!complaint.empty()) {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0) std::cerr << "ERROR: " << complaint << std::endl;
    MPI_Finalize();
    return 1;
  }
  LAMMPS_NS::LAMMPS* engine = new LAMMPS_NS::LAMMPS(argc, argv, MPI_COMM_WORLD);
  engine->input->file();
  delete engine;
  MPI_Finalize();
  return 0;
}
