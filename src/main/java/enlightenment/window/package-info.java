/** A window that shows a render; the only place with Swing. It needs a display, and a Java that is not made for machines without one. */
package enlightenment.window;
