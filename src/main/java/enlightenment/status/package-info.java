/**
 * The status of a render while it runs. {@link enlightenment.status.StatusSource} is implemented by all kinds of renders;
 * {@link enlightenment.status.StatusServer} shows it on a page on loopback.
 */
package enlightenment.status;
