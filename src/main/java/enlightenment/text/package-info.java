/** Text from elsewhere made harmless before anybody reads it. */
package enlightenment.text;
