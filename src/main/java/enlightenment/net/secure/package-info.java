/** Authentication: the token that both sides prove to know, TLS, and the files with secrets. */
package enlightenment.net.secure;
