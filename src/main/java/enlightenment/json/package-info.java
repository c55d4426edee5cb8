/** JSON that the program writes for other programs: reports, measurements, the status of a server. Not exported. */
package enlightenment.json;
