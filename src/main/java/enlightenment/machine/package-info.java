/** What the machine and the program around us offer, asked so that nothing fails where it is missing. Internal. */
package enlightenment.machine;
