/** Accumulation of the passes of a view: sums, noise, and the frame that is shown. */
package enlightenment.view.frame;
