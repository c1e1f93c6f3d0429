package starlogo.collision.snapshots
{
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
        // Bytes: two indices, the walker's place, and the place, the size and the rotation of the agent below.
        private static const SIZE:int = 8 + 8 * (3 + 4 + 9);
        private static const ROTATION:int = 9;

        /** Writes what the agents of a table's list stand on, if it is in the list too. */
        public static function write(bytes:ByteArray, agents:Vector.<Agent>, table:AgentTable):void
        {
            var countAt:uint = bytes.position;
            var count:int = 0;
            bytes.writeInt(0);
            for (var i:int = 0; i < agents.length; i++)
            {
                var link:PlatformLink = agents[i].platformLink;
                if (link == null || !link.isValid || table.list.rowOf(link.platform) < ListedAgents.FIRST_LISTED)
                {
                    continue;
                }
                count++;
                bytes.writeInt(i);
                bytes.writeInt(table.list.ranks[table.list.rowOf(link.platform)]);
                writeNumbers(bytes, link.place.x, link.place.y, link.place.z);
                var below:Placement = link.platformPlace;
                writeNumbers(bytes, below.x, below.y, below.z);
                bytes.writeDouble(below.size);
                var rotation:Vector.<Number> = new Vector.<Number>(ROTATION, true);
                below.writeRotation(rotation, 0);
                for (var k:int = 0; k < ROTATION; k++)
                {
                    bytes.writeDouble(rotation[k]);
                }
            }
            bytes.position = countAt;
            bytes.writeInt(count);
            bytes.position = bytes.length;
        }

        /** Passes over the bytes of what this number of agents stand on. Returns whether they are that. @throws EOFError if they are cut off */
        public static function passOver(bytes:ByteArray, agents:int):Boolean
        {
            var left:uint = bytes.readUnsignedInt();
            if (left > agents || left * SIZE > bytes.bytesAvailable)
            {
                return false;
            }
            for (; left > 0; left--)
            {
                var walker:uint = bytes.readUnsignedInt();
                var on:uint = bytes.readUnsignedInt();
                var isValid:Boolean = walker < agents && on < agents && walker != on && isInWorld(bytes.readDouble(), bytes.readDouble(), bytes.readDouble());
                if (!isValid || !readPlacement(bytes, new Placement()))
                {
                    return false;
                }
            }
            return true;
        }

        /** Lets agents stand as they stood when it was written. */
        public static function restore(bytes:ByteArray, agents:Vector.<Agent>):void
        {
            for (var i:int = 0; i < agents.length; i++)
            {
                if (agents[i].platformLink != null)
                {
                    agents[i].platformLink.platform = null;
                }
            }
            for (var left:uint = bytes.readUnsignedInt(); left > 0; left--)
            {
                var walker:Agent = agents[bytes.readUnsignedInt()];
                var link:PlatformLink = walker.platformLink ||= new PlatformLink(walker);
                link.platform = agents[bytes.readUnsignedInt()];
                link.platformRevision = link.platform.revision;
                link.place.setTo(bytes.readDouble(), bytes.readDouble(), bytes.readDouble());
                readPlacement(bytes, link.platformPlace);
            }
        }

        private static function writeNumbers(bytes:ByteArray, x:Number, y:Number, z:Number):void
        {
            bytes.writeDouble(x);
            bytes.writeDouble(y);
            bytes.writeDouble(z);
        }

        // Returns whether an agent can have the placement.
        private static function readPlacement(bytes:ByteArray, out:Placement):Boolean
        {
            out.x = bytes.readDouble();
            out.y = bytes.readDouble();
            out.z = bytes.readDouble();
            out.size = bytes.readDouble();
            var rotation:Vector.<Number> = new Vector.<Number>(ROTATION, true);
            for (var k:int = 0; k < ROTATION; k++)
            {
                rotation[k] = bytes.readDouble();
            }
            out.readRotation(rotation, 0);
            return isInWorld(out.x, out.y, out.z) && out.size >= Agent.SMALLEST_SIZE && out.size <= Agent.LARGEST_SIZE && out.isRotation;
        }
    }
}
