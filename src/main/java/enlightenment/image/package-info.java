/** Finished pictures: kept, read and written, and compared with each other. */
package enlightenment.image;
