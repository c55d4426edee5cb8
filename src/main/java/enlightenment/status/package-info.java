/**
 * What is shown of a render while it runs: {@link enlightenment.status.StatusSource} is what watches need, of whatever renders;
 * {@link enlightenment.status.StatusServer} shows it on a page on loopback.
 */
package enlightenment.status;
