/** ꟻLIP: how different two pictures look to somebody who flips between them. */
package enlightenment.image.flip;
