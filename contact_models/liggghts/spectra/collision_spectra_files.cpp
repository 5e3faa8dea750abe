// SPDX-License-Identifier: GPL-2.0-or-later
//
// Deck line, table file and restart data of fix collision_spectra.
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "atom.h"
#include "comm.h"
#include "liggghts/spectra/collision_spectra.h"

namespace plastigran {

namespace {

const char heading[] = "step,quantity,with,type,other_type,lower,upper,count,sum\n";
const char* const quantities[] = {"normal_speed", "dissipated_energy", "largest_force"};

// Largest value of per_decade, the number of classes per factor of 10. The edges of narrower
// classes would differ only in the last printed digits.
const long most_per_decade = 1000;

// Returns the number in `word`; 0 unless the word is a positive integer.
long positive_number(const char* word) {
  char* end;
  const long number = std::strtol(word, &end, 10);
  return *end == '\0' && number > 0 ? number : 0;
}

}  // namespace

void CollisionSpectra::read_words(int count, char** words) {
  if (count < 4 || !(every_ = positive_number(words[3])))
    fail(std::string("EVERY is ") + (count < 4 ? "missing" : words[3]) +
         "; it must be a positive number of steps, the first word after collision_spectra");
  for (int k = 4; k < count; k += 2) {
    const std::string word = words[k];
    if (word != "file" && word != "per_decade")
      fail("unknown word " + word + "; possible: file, per_decade");
    if (k + 1 == count) fail(word + " has no value");
    if (word == "file") {
      path_ = words[k + 1];
      continue;
    }
    const long number = positive_number(words[k + 1]);
    if (number < 1 || number > most_per_decade)
      fail(std::string("per_decade is ") + words[k + 1] + "; it must be a whole number from 1 to " +
           std::to_string(most_per_decade));
    per_decade_ = number;
  }
  if (path_.empty()) fail("`file FILE` is missing. Add it to the line");
  for (const CollisionSpectra* const other : fixes_of<CollisionSpectra>(modify))
    if (other->path_ == path_)
      fail("fix " + std::string(other->id) + " writes the file " + path_ +
           " already. Choose another file");
  if (comm->me == 0) open(path_);
}

// Opens the table file on rank 0. Keeps the tables up to the current step, and drops later ones,
// because a run from a restart file writes them again.
void CollisionSpectra::open(const std::string& path) {
  std::string kept = heading;
  std::ifstream before(path);
  std::string line;
  std::getline(before, line);
  if (!line.empty() && line + '\n' != heading)
    stop_from_rank(lmp,
                   name() + ": the file " + path +
                       " is not a table of collision spectra. Choose another name, so that it is "
                       "not overwritten");
  while (std::getline(before, line) &&
         !before.eof())  // skip a truncated last line, which a killed run may leave
    if (std::atoll(line.c_str()) <= update->ntimestep) kept += line + '\n';
  before.close();
  file_.reset(std::fopen(path.c_str(), "w"));
  if (!file_)
    stop_from_rank(lmp, name() + ": cannot write " + path + " (" + std::strerror(errno) + ')');
  std::fputs(kept.c_str(), file_.get());
  std::fflush(file_.get());
}

void CollisionSpectra::write_table() {
  const Tally all = tally_.of_all(world);
  tally_.clear();
  if (!file_) return;
  for (const auto& [key, count] : all.counts()) {
    const bool positive = key.bin != Tally::no_bin;
    std::fprintf(file_.get(), BIGINT_FORMAT ",%s,%s,%d,%d,%.10g,%.10g,%.0f,%.15g\n",
                 update->ntimestep, quantities[key.quantity],
                 key.wall < 0 ? "particle" : wall_ids_[key.wall].c_str(), key.type, key.other_type,
                 Tally::edge(key.bin, per_decade_),
                 positive ? Tally::edge(key.bin + 1, per_decade_) : 0, count.number, count.sum);
  }
  std::fflush(file_.get());
}

// Packs the impacts of a particle. The first value is the number of values, as LIGGGHTS requires.
int CollisionSpectra::pack_restart(int i, double* buffer) {
  buffer[0] = size_restart(i);
  records_.write(i, buffer + 1);
  buffer[1] = atom->tag[i];
  return size_restart(i);
}

// Reads the impacts of a particle. atom->extra contains the values of several fixes one after
// another; each begins with its number of values. `nth` is the number of fixes before this one.
void CollisionSpectra::unpack_restart(int i, int nth) {
  const double* values = atom->extra[i];
  for (int k = 0; k < nth; ++k) values += static_cast<int>(*values);
  records_.read(i, values + 1);
}

int CollisionSpectra::maxsize_restart() {
  int largest = 1 + records_.largest_size(atom->nlocal);
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_INT, MPI_MAX, world);
  return largest;
}

// Writes the state as text to the restart file: number of particles, number and energy of counted
// impacts, energy of all other contacts, per_decade, number and IDs of walls, and the counts since
// the last table.
void CollisionSpectra::write_restart(FILE* file) {
  const double impacts = compute_vector(IMPACTS), impact_energy = compute_vector(IMPACT_ENERGY);
  const double contact_energy = compute_vector(CONTACT_ENERGY);
  const Tally all = tally_.of_all(world);
  std::ostringstream text;
  text << std::setprecision(17) << atom->natoms << ' ' << impacts << ' ' << impact_energy << ' '
       << contact_energy << ' ' << per_decade_ << ' ' << wall_ids_.size();
  for (const std::string& wall : wall_ids_) text << ' ' << wall;
  for (const double value : all.packed()) text << ' ' << value;
  write_state(file, text.str().c_str(), text.str().size() + 1);
}

void CollisionSpectra::restart(char* data) {
  std::istringstream text(data);
  double impacts, impact_energy, contact_energy;
  int per_decade;
  std::size_t wall_count;
  text >> particle_total_ >> impacts >> impact_energy >> contact_energy >> per_decade >> wall_count;
  wall_ids_.resize(wall_count);
  for (std::string& wall : wall_ids_) text >> wall;
  if (per_decade != per_decade_)
    fail("the restart file has per_decade " + std::to_string(per_decade) + ", but the line has " +
         std::to_string(per_decade_) + ". Use the value of the restart file, or another fix ID");
  if (comm->me != 0) return;  // rank 0 takes the sums of all ranks
  impacts_ = impacts, impact_energy_ = impact_energy;
  energy_ = impact_energy + contact_energy;
  std::vector<double> packed;
  for (double value; text >> value;) packed.push_back(value);
  tally_.merge(packed);
}

}  // namespace plastigran
