/** Luminous intensity by direction, as manufacturers of luminaires publish it: tables, and the IES files that hold them. */
package enlightenment.photometry;
