// The C interface of SQLite, in this file alone.
#include "torse/fuzz/campaign/sqlite.hpp"

#include <sqlite3.h>

#include <filesystem>
#include <utility>

#include "torse/io/document.hpp"

namespace torse::fuzz {
namespace {

constexpr int milliseconds_to_wait = 60000;

[[noreturn]] void fail(const std::string& file, sqlite3* connection) {
  const int code = sqlite3_errcode(connection);
  if (code == SQLITE_NOTADB) throw FileError(file, "expected a database of torse campaign, found another file");
  throw FileError(file, std::string("the database cannot be used: ") + sqlite3_errmsg(connection));
}

}  // namespace

void Statement::Closer::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
void Database::Closer::operator()(sqlite3* connection) const { sqlite3_close_v2(connection); }

Statement::Statement(std::string file, sqlite3* connection, std::string_view sql)
    : file_(std::move(file)), connection_(connection) {
  sqlite3_stmt* made = nullptr;
  const int code = sqlite3_prepare_v2(connection, sql.data(), static_cast<int>(sql.size()), &made, nullptr);
  statement_.reset(made);
  if (code != SQLITE_OK) fail(file_, connection);
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) fail(file_, connection_);
  sqlite3_reset(statement_.get());
  return false;
}

void Statement::run() {
  while (step()) {
  }
}

void Statement::reset() {
  sqlite3_reset(statement_.get());
  sqlite3_clear_bindings(statement_.get());
}

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }
double Statement::real(int column) const { return sqlite3_column_double(statement_.get(), column); }

std::string Statement::text(int column) const {
  const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement_.get(), column));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return bytes == nullptr ? std::string() : std::string(bytes, size);
}

void Statement::bind_one(int index, std::int64_t value) {
  if (sqlite3_bind_int64(statement_.get(), index, value) != SQLITE_OK) fail(file_, connection_);
}

void Statement::bind_one(int index, double value) {
  if (sqlite3_bind_double(statement_.get(), index, value) != SQLITE_OK) fail(file_, connection_);
}

void Statement::bind_one(int index, std::string_view value) {
  if (sqlite3_bind_text64(statement_.get(), index, value.data(), value.size(), SQLITE_TRANSIENT, SQLITE_UTF8) !=
      SQLITE_OK) {
    fail(file_, connection_);
  }
}

Database::Database(const std::string& file, Open how) : file_(file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw FileError(file, "expected a file, found a folder");
  const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX | (how == Open::create ? SQLITE_OPEN_CREATE : 0);
  sqlite3* opened = nullptr;
  // A relative path in front of the name: SQLite takes ":memory:" and "" for no file at all.
  const std::string path = std::filesystem::path(file).is_absolute() ? file : "./" + file;
  const int code = sqlite3_open_v2(path.c_str(), &opened, flags, nullptr);
  connection_.reset(opened);
  if (opened == nullptr) throw FileError(file, "the database cannot be used: out of memory");
  if (code != SQLITE_OK) fail(file, opened);
  sqlite3_extended_result_codes(opened, 0);
  sqlite3_busy_timeout(opened, milliseconds_to_wait);
  run("PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON");
}

void Database::run(const std::string& sql) const {
  if (sqlite3_exec(connection_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    fail(file_, connection_.get());
  }
}

std::int64_t Database::number(std::string_view sql) const {
  Statement statement = prepare(sql);
  return statement.bind().step() ? statement.integer(0) : 0;
}

std::int64_t Database::changes() const { return sqlite3_changes64(connection_.get()); }

Transaction::~Transaction() {
  if (!open_) return;
  try {
    database_.run("ROLLBACK");
  } catch (const FileError&) {
    // SQLite has rolled back already where the error that leads here was one of the disk.
  }
}

void Transaction::commit() {
  database_.run("COMMIT");
  open_ = false;
}

}  // namespace torse::fuzz
