/** Taking connections from anybody: a port, a bounded number of places, and a log that strangers cannot fill. */
package enlightenment.listen;
