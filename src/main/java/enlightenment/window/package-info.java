/** A window that shows a render, the only package with Swing. It needs a display, and a Java with desktop support. */
package enlightenment.window;
