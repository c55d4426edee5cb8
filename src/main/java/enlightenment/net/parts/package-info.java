/** Renders in parts that know nothing of each other, for job arrays. */
package enlightenment.net.parts;
