/** Surfaces that touch or coincide: which face of a solid lies on which other, so that a ray crosses each interface once and in order. */
package enlightenment.world.contact;
