package starlogo.queries.motion
{
    import starlogo.convex.ContactPoint;

    /**
     * A list of contacts with rows, whose memory is used again. Of contacts whose normals are the same, up to rounding, it keeps the newest.
     *
     * @private
     */
    public final class ContactList
    {
        // Two normals are the same if the cosine of the angle between them is greater than this.
        private static const SAME:Number = 1 - 1e-14;

        /** The number of contacts. Read only. */
        public var count:int = 0;

        /** The contacts. Read only. */
        public var contacts:Vector.<ContactPoint> = new Vector.<ContactPoint>();

        /** By contact: the row that it belongs to. Read only. */
        public var rows:Vector.<int> = new Vector.<int>();

        /** Removes all contacts. */
        public function clear():void
        {
            count = 0;
        }

        /**
         * Adds a copy of a contact. It takes the place of a contact with the same normal.
         *
         * @return the index of the contact
         */
        public function add(contact:ContactPoint, row:int):int
        {
            var index:int = 0;
            while (index < count && !isSame(contacts[index], contact))
            {
                index++;
            }
            if (index == contacts.length)
            {
                contacts.push(new ContactPoint());
            }
            contacts[index].copyFrom(contact);
            rows[index] = row;
            count = Math.max(count, index + 1);
            return index;
        }

        /** Removes a contact. The last one takes its index. */
        public function remove(index:int):void
        {
            count--;
            contacts[index].copyFrom(contacts[count]);
            rows[index] = rows[count];
        }

        private static function isSame(a:ContactPoint, b:ContactPoint):Boolean
        {
            return a.normalX * b.normalX + a.normalY * b.normalY + a.normalZ * b.normalZ > SAME;
        }
    }
}
