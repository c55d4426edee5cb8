/**
 * What is made of finished pictures beyond what {@link enlightenment.image} exports: maps of numbers as pictures, and what rounding to a
 * file's depth costs.
 */
package enlightenment.picture;
