/**
 * The sample store: results of units, and the samples behind them, in a relational database; SQLite unless somebody says otherwise.
 * The only package that sees {@code java.sql}. docs/guide/sample-store.md tells of schema, queries and what is safe when.
 */
package enlightenment.store;
