/** By how much one picture differs from another, in figures. */
package enlightenment.image.error;
