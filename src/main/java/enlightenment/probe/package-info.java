/** What one pixel's rays meet, for tools that look. */
package enlightenment.probe;
