/** Scenes of Mitsuba 3, with the names of Mitsuba 2 and 0.6, in XML. */
package enlightenment.importer.mitsuba;
