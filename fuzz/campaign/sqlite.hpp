// SQLite with errors as FileError, whose file is the database.
//   Database       an open database file        Statement      one prepared statement
//   Transaction    all or nothing
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace torse::fuzz {

/// One prepared statement. Between its last row, `run` or `reset` and the next `bind` it holds no lock.
class Statement {
 public:
  /// Gives the parameters their values, in order, and starts anew.
  template <class... T>
  Statement& bind(const T&... values) {
    reset();
    int index = 0;
    (bind_one(++index, values), ...);
    return *this;
  }
  /// Goes to the next row; false behind the last one.
  bool step();
  /// Runs a statement without rows.
  void run();
  void reset();

  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string text(int column) const;

 private:
  friend class Database;
  struct Closer {
    void operator()(sqlite3_stmt* statement) const;
  };
  Statement(std::string file, sqlite3* connection, std::string_view sql);

  void bind_one(int index, std::int64_t value);
  void bind_one(int index, double value);
  void bind_one(int index, std::string_view value);

  std::string file_;
  sqlite3* connection_;
  std::unique_ptr<sqlite3_stmt, Closer> statement_;
};

/// An open database file, for one thread. Who waits for another process waits for a minute at most.
class Database {
 public:
  /// Whether a file that is not there is an error.
  enum class Open { existing, create };

  /// Throws FileError for a file that cannot be opened or is no database.
  Database(const std::string& file, Open how);

  const std::string& file() const { return file_; }
  Statement prepare(std::string_view sql) const { return {file_, connection_.get(), sql}; }
  /// Runs statements without parameters and without rows.
  void run(const std::string& sql) const;
  /// The one number that a statement gives.
  std::int64_t number(std::string_view sql) const;
  /// The rows that the last statement changed.
  std::int64_t changes() const;

 private:
  struct Closer {
    void operator()(sqlite3* connection) const;
  };
  std::string file_;
  std::unique_ptr<sqlite3, Closer> connection_;
};

/// Writes between its begin and `commit` become visible, and lasting, all at once; without `commit` none of them does.
class Transaction {
 public:
  explicit Transaction(const Database& database) : database_(database) { database.run("BEGIN IMMEDIATE"); }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();
  void commit();

 private:
  const Database& database_;
  bool open_ = true;
};

}  // namespace torse::fuzz
