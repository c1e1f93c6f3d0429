package starlogo.collision.snapshots
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.agents.PlatformLink;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.isInWorld;
    import starlogo.search.table.AgentTable;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * Writes and reads what agents stand on since their last walks.
     *
     * @private
     */
    internal final class SnapshotPlatforms
    {
        // The numbers after the indices of two agents: the walker's place, and the place, the size and the rotation of the agent below.
        private static const NUMBERS:int = 3 + 4 + 9;

        /** Writes what the agents of a table's list stand on, if it is in the list too. An agent may have been moved away from there, and come back. */
        public static function write(bytes:ByteArray, agents:Vector.<Agent>, table:AgentTable):void
        {
            var countAt:uint = bytes.position;
            var count:int = 0;
            bytes.writeInt(0);
            for (var i:int = 0; i < agents.length; i++)
            {
                var link:PlatformLink = agents[i].platformLink;
                if (link == null || !link.hasPlatform || table.listed.rowOf(link.platform) < ListedAgents.FIRST_LISTED)
                {
                    continue;
                }
                count++;
                bytes.writeInt(i);
                bytes.writeInt(table.listed.listIndices[table.listed.rowOf(link.platform)]);
                var at:Vector3D = link.walkerPlace;
                var below:Placement = link.platformPlacement;
                var numbers:Vector.<Number> = new <Number>[at.x, at.y, at.z, below.x, below.y, below.z, below.size];
                below.readRows(numbers, numbers.length);
                for (var k:int = 0; k < NUMBERS; k++)
                {
                    bytes.writeDouble(numbers[k]);
                }
            }
            bytes.position = countAt;
            bytes.writeInt(count);
            bytes.position = bytes.length;
        }

        /**
         * Reads what agents stand on: for each agent its link, or null.
         *
         * @throws RangeError if the bytes are not that
         * @throws EOFError if they are cut off
         */
        public static function read(bytes:ByteArray, agents:Vector.<Agent>):Vector.<PlatformLink>
        {
            var left:uint = bytes.readUnsignedInt();
            var links:Vector.<PlatformLink> = new Vector.<PlatformLink>(agents.length);
            for (; left > 0; left--)
            {
                var walker:uint = bytes.readUnsignedInt();
                var on:uint = bytes.readUnsignedInt();
                if (walker >= agents.length || on >= agents.length || walker == on || links[walker] != null)
                {
                    throw new RangeError("an agent stands on none of the list, or on two");
                }
                var link:PlatformLink = new PlatformLink();
                var numbers:Vector.<Number> = new Vector.<Number>();
                while (numbers.length < NUMBERS)
                {
                    numbers.push(bytes.readDouble());
                }
                var below:Placement = link.platformPlacement;
                below.x = numbers[3];
                below.y = numbers[4];
                below.z = numbers[5];
                below.size = numbers[6];
                below.setRows(numbers, 7);
                if (!isInWorld(numbers[0], numbers[1], numbers[2]) || !isInWorld(below.x, below.y, below.z) || !Agent.isSize(below.size) || !below.isRotation)
                {
                    throw new RangeError("a platform's place is not allowed");
                }
                link.platform = agents[on];
                link.walkerPlace.setTo(numbers[0], numbers[1], numbers[2]);
                links[walker] = link;
            }
            return links;
        }

        /** Gives each agent what was read for it. */
        public static function restore(links:Vector.<PlatformLink>, agents:Vector.<Agent>):void
        {
            for (var i:int = 0; i < agents.length; i++)
            {
                agents[i].platformLink = links[i];
                if (links[i] != null)
                {
                    links[i].platformRevision = links[i].platform.revision;
                }
            }
        }
    }
}
