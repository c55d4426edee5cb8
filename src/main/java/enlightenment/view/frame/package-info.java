/** What passes of a view add up to: sums, noise and the frame that is shown. */
package enlightenment.view.frame;
