// This folder takes a Collision back to earlier frames. Snapshots writes and reads the bytes: SnapshotPlaces, SnapshotPlatforms, SnapshotTraits and
// SnapshotNames each a part of them. SnapshotRegister knows whose agents the last snapshots are of. Read this file first, then SnapshotPlaces.
package starlogo.collision.snapshots
{
    import flash.errors.EOFError;
    import flash.errors.IllegalOperationError;
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.agents.PlatformLink;
    import starlogo.agents.copyAgents;
    import starlogo.collision.LastFrame;
    import starlogo.engine;
    import starlogo.ground.HeightGrid;
    import starlogo.handlers.Touch;
    import starlogo.handlers.TouchTracker;
    import starlogo.search.CollisionSearch;
    import starlogo.search.table.AgentTable;
    import starlogo.search.EnvironmentAgent;

    use namespace engine;

    /**
     * Writes and reads the snapshots of one Collision. A snapshot has what the next frame needs besides the agents' traits, and the traits if
     * asked. Agents are numbers in it: their indices in the last frame's list.
     *
     * <p>The bytes are: a mark; what is in the snapshot; the number of agents; names; for each agent whether it may have a motion from its last
     * position, and that position; the touching pairs, and for each its agents, their breeds, and whether it touches both ways; what agents stand
     * on; the ground; the traits. In a pair, the indices after those of the agents are the ground, the edges, and a ground and edges that were
     * exchanged after the frame: their touches end in the next frame.</p>
     *
     * <p>Nothing in the bytes depends on the program that runs. Machines in step write the same bytes.</p>
     *
     * @private
     */
    public final class Snapshots
    {
        // "SLF5"
        private static const MARK:uint = 0x534C4635;

        // What is in a snapshot, as a sum: traits; whether there was ground; the ground's heights.
        private static const HAS_TRAITS:int = 1;
        private static const HAS_GROUND:int = 2;
        private static const HAS_HEIGHTS:int = 4;

        // The factor of the number of the collision system, which is in the bits above these.
        private static const SYSTEM_FACTOR:int = 8;

        // The names of the collision systems (BaseShapeChoice.systemName). Their indices stand in snapshots, so they keep this order.
        private static const SYSTEMS:Array = ["a collider of the game's own", "a BinCollider", "a TightestFitCollider", "a HierarchicalCollider", "a CombinationCollider",
                "a LevelCollider"];

        private static const DAMAGED:String = "bytes are no snapshot any more: they begin as one, but something in them was changed or cut off";

        private var _register:SnapshotRegister = new SnapshotRegister();

        // They stand for the ground and the edges that were exchanged before a snapshot, if the register does not know them.
        private var _unknownEnvironment:Vector.<Agent> = new <Agent>[new EnvironmentAgent(Breeds.TERRAIN), new EnvironmentAgent(Breeds.EDGE)];

        /**
         * Returns the bytes of a snapshot.
         *
         * @param search makes the next frame. If it has not made the last one, no agent has a motion
         * @param ground the ground, or null
         * @param edges the edges of the world, or null
         * @param withTraits whether the agents' traits are written
         * @param withGround whether the ground's heights are written
         * @throws IllegalOperationError if the frame has failed, or if the collision system has searched another list since
         */
        public function write(frame:LastFrame, search:CollisionSearch, ground:EnvironmentAgent, edges:EnvironmentAgent, withTraits:Boolean,
                withGround:Boolean):ByteArray
        {
            var agents:Vector.<Agent> = frame.agents;
            var table:AgentTable = (frame.search || search).table;
            if (agents.length > 0 && (frame.search == null || !table.listed.isListed(agents)))
            {
                throw new IllegalOperationError(frame.search == null
                        ? "the last frame has refused its list, failed, or had a collision system of the game's own: there is nothing to take a snapshot of"
                        : "the collision system has searched another list since the last frame");
            }
            var hasHeights:Boolean = withGround && ground != null;
            var names:SnapshotNames = new SnapshotNames();
            var rest:ByteArray = newBytes();
            SnapshotPlaces.write(rest, agents, table, frame.search === search);
            var formerEnvironment:Vector.<Agent> = writeTouches(rest, names, frame.tracker.inOrder(), table, ground, edges);
            SnapshotPlatforms.write(rest, agents, table);
            if (hasHeights)
            {
                ground.surface.grid.writeTo(rest);
            }
            if (withTraits)
            {
                SnapshotTraits.write(rest, agents, names);
            }
            var bytes:ByteArray = newBytes();
            bytes.writeUnsignedInt(MARK);
            bytes.writeByte(int(withTraits) * HAS_TRAITS + int(ground != null) * HAS_GROUND + int(hasHeights) * HAS_HEIGHTS
                    + SYSTEMS.indexOf(search.narrowPhase.shapeChoice.systemName) * SYSTEM_FACTOR);
            bytes.writeInt(agents.length);
            names.write(bytes);
            bytes.writeBytes(rest);
            _register.note(bytes, agents, formerEnvironment);
            bytes.position = 0;
            return bytes;
        }

        /**
         * Goes back to a snapshot. The last search is then the one before the snapshot was taken.
         *
         * @param search will make the next frame
         * @param ground the ground, or null. It gets the heights that are in the snapshot
         * @param edges the edges of the world, or null
         * @param frame becomes the frame of the snapshot
         * @throws ArgumentError as Collision.restore does; nothing has changed then
         */
        public function restore(bytes:ByteArray, agents:Vector.<Agent>, search:CollisionSearch, ground:EnvironmentAgent, edges:EnvironmentAgent,
                frame:LastFrame):void
        {
            search.table.listed.propose(agents);
            var copy:ByteArray = newBytes();
            copy.writeBytes(bytes);
            copy.position = 0;
            if (copy.length < 4 || copy.readUnsignedInt() != MARK)
            {
                throw new ArgumentError("bytes are no snapshot: they do not begin as one");
            }
            var names:SnapshotNames = new SnapshotNames();
            try
            {
                var contents:int = readContents(copy, search.narrowPhase.shapeChoice.systemName, ground != null);
                var count:uint = copy.readUnsignedInt();
                requireIntact(count <= copy.bytesAvailable / SnapshotPlaces.SIZE);
                var formerEnvironment:Vector.<Agent> = _register.recallFormerEnvironment(copy, count, agents) || _unknownEnvironment;
                names.read(copy);
                var places:Vector.<Number> = SnapshotPlaces.read(copy, count);
                var touches:TouchTracker = readTouches(copy, agents, new <Agent>[ground, edges].concat(formerEnvironment), names);
                var links:Vector.<PlatformLink> = SnapshotPlatforms.read(copy, agents);
                var heights:HeightGrid = (contents & HAS_HEIGHTS) != 0 ? ground.surface.grid.readFrom(copy) : null;
                var hasTraits:Boolean = (contents & HAS_TRAITS) != 0;
                requireIntact(hasTraits || copy.position == copy.length);
            }
            catch (error:Error)
            {
                throw refusalOf(error);
            }
            restoreAgents(copy, agents, search, places, hasTraits ? names : null);
            SnapshotPlatforms.restore(links, agents);
            if (heights != null)
            {
                ground.restoreGrid(heights);
            }
            frame.tracker = touches;
            frame.agents = copyAgents(agents, frame.agents);
            frame.search = search;
        }

        // Puts the agents back: their traits, which the bytes have next if there are names for them, and their places in the last frame. If that fails,
        // the agents have the traits that they had before.
        private function restoreAgents(bytes:ByteArray, agents:Vector.<Agent>, search:CollisionSearch, places:Vector.<Number>, names:SnapshotNames):void
        {
            var namesBefore:SnapshotNames = new SnapshotNames();
            var before:ByteArray = newBytes();
            try
            {
                if (names != null)
                {
                    SnapshotTraits.write(before, agents, namesBefore);
                    readTraits(bytes, agents, names);
                }
                SnapshotPlaces.restore(places, agents, search.table);
                search.forgetPairs();
            }
            catch (error:Error)
            {
                if (names != null)
                {
                    before.position = 0;
                    SnapshotTraits.restore(before, agents, namesBefore);
                }
                throw error;
            }
        }

        private static function readTraits(bytes:ByteArray, agents:Vector.<Agent>, names:SnapshotNames):void
        {
            try
            {
                SnapshotTraits.restore(bytes, agents, names);
                requireIntact(bytes.position == bytes.length);
            }
            catch (error:Error)
            {
                throw refusalOf(error);
            }
        }

        // Returns the ground and the edges of touches that were exchanged, for restore(); null if none were.
        private function writeTouches(bytes:ByteArray, names:SnapshotNames, touches:Vector.<Touch>, table:AgentTable, ground:EnvironmentAgent,
                edges:EnvironmentAgent):Vector.<Agent>
        {
            var formerEnvironment:Vector.<Agent> = null;
            bytes.writeInt(touches.length);
            for (var i:int = 0; i < touches.length; i++)
            {
                var touch:Touch = touches[i];
                // the ground comes before the edges
                var environmentIndex:int = touch.second.breed == Breeds.TERRAIN ? 0 : 1;
                var second:int;
                if (!touch.second.isEnvironment)
                {
                    second = table.listed.listIndices[table.listed.rowOf(touch.second)];
                }
                else if (touch.second === ground || touch.second === edges)
                {
                    second = table.listed.rows.count + environmentIndex;
                }
                else
                {
                    formerEnvironment ||= _unknownEnvironment.concat();
                    formerEnvironment[environmentIndex] = touch.second;
                    second = table.listed.rows.count + formerEnvironment.length + environmentIndex;
                }
                bytes.writeInt(table.listed.listIndices[table.listed.rowOf(touch.first)]);
                bytes.writeInt(second);
                bytes.writeInt(names.numberOf(Breeds.NAMES.nameOf(touch.firstBreed)));
                bytes.writeInt(names.numberOf(Breeds.NAMES.nameOf(touch.secondBreed)));
                bytes.writeBoolean(touch.hasReachedSecond);
            }
            return formerEnvironment;
        }

        // Reads what is in a snapshot. It has to be of the same kind of collision system, and with ground or without, as the Collision is.
        private static function readContents(bytes:ByteArray, systemName:String, isGroundThere:Boolean):int
        {
            var contents:int = bytes.readUnsignedByte();
            var writtenBy:int = contents / SYSTEM_FACTOR;
            requireIntact(writtenBy < SYSTEMS.length && (contents & (HAS_GROUND | HAS_HEIGHTS)) != HAS_HEIGHTS);
            if (SYSTEMS[writtenBy] != systemName)
            {
                throw new ArgumentError("bytes are no snapshot of a Collision with " + systemName + ": that one had " + SYSTEMS[writtenBy]);
            }
            if (isGroundThere != ((contents & HAS_GROUND) != 0))
            {
                var which:String = isGroundThere ? "with" : "without";
                throw new ArgumentError("bytes are no snapshot of a Collision " + which + " ground");
            }
            return contents;
        }

        // @param environment the ground and the edges, or null, and those that were exchanged
        private static function readTouches(bytes:ByteArray, agents:Vector.<Agent>, environment:Vector.<Agent>, names:SnapshotNames):TouchTracker
        {
            var partners:Vector.<Agent> = agents.concat(environment);
            var touches:TouchTracker = new TouchTracker();
            var pairs:uint = bytes.readUnsignedInt();
            for (var left:uint = pairs; left > 0; left--)
            {
                var first:uint = bytes.readUnsignedInt();
                var second:uint = bytes.readUnsignedInt();
                var firstBreed:int = Breeds.NAMES.numberOf(names.nameAt(bytes.readUnsignedInt()));
                var secondBreed:int = Breeds.NAMES.numberOf(names.nameAt(bytes.readUnsignedInt()));
                var flag:int = bytes.readUnsignedByte();
                requireIntact(first < agents.length && second < partners.length && first != second && flag <= 1);
                if (partners[second] == null)
                {
                    var missing:String = second == agents.length ? "ground" : "bounds";
                    throw new ArgumentError("bytes are no snapshot of a Collision without " + missing);
                }
                // the ground and the edges keep their breeds, which no other agent ever has
                var partner:Agent = partners[second];
                requireIntact(firstBreed > Breeds.ANY_NUMBER && (partner.isEnvironment ? secondBreed == partner.breedNumber : secondBreed > Breeds.ANY_NUMBER));
                // each pair is there once
                requireIntact(touches.find(agents[first], partner) == null);
                touches.start(agents[first], partner, firstBreed, secondBreed).hasReachedSecond = flag == 1;
            }
            return touches;
        }

        private static function requireIntact(isSnapshot:Boolean):void
        {
            if (!isSnapshot)
            {
                throw new ArgumentError(DAMAGED);
            }
        }

        // The error for a caller. Damaged bytes end too early, or have a name, a height or a trait that is not allowed.
        private static function refusalOf(error:Error):Error
        {
            return error is EOFError || error is RangeError ? new ArgumentError(DAMAGED) : error;
        }

        private static function newBytes():ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            bytes.endian = Endian.LITTLE_ENDIAN;
            return bytes;
        }
    }
}
