package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.Extents;
    import starlogo.engine;

    use namespace engine;

    /**
     * How the agents of a table have moved from the search before to the last one, in which an agent sweeps: by row, with the extents of all
     * that they moved through.
     *
     * @private
     */
    public final class Motions
    {
        /** By row: the motion, 0 where there is none. */
        public var x:Vector.<Number> = new Vector.<Number>();

        /** @copy #x */
        public var y:Vector.<Number> = new Vector.<Number>();

        /** @copy #x */
        public var z:Vector.<Number> = new Vector.<Number>();

        /** By row: whether the agent sweeps, and has a motion. */
        public var isSweeping:Vector.<Boolean> = new Vector.<Boolean>();

        /** By row: the extents of the motion, its ends included. */
        public var extents:Extents = new Extents();

        /** No motions. */
        public function Motions()
        {
        }

        /** Whether an agent of a list sweeps. */
        public static function isOneSweeping(agents:Vector.<Agent>):Boolean
        {
            for (var i:int = agents.length - 1; i >= 0; i--)
            {
                if (agents[i].isSweeping)
                {
                    return true;
                }
            }
            return false;
        }

        /** Finds the motions of a table that has just been read. */
        public function find(table:AgentTable, bins:Bins):void
        {
            makeRows(table.agents.length);
            var standing:Extents = table.extents;
            var swept:Extents = extents;
            for (var i:int = 0; i < table.count; i++)
            {
                var row:int = table.rows[i];
                var hasMotion:Boolean = table.hasMotion(row);
                var motionX:Number = hasMotion ? table.x[row] - table.lastX[row] : 0;
                var motionY:Number = hasMotion ? table.y[row] - table.lastY[row] : 0;
                var motionZ:Number = hasMotion ? table.z[row] - table.lastZ[row] : 0;
                var halfX:Number = standing.halfX[row] + Math.abs(motionX) / 2;
                var halfY:Number = standing.halfY[row] + Math.abs(motionY) / 2;
                isSweeping[row] = hasMotion && table.agents[row].isSweeping;
                x[row] = motionX;
                y[row] = motionY;
                z[row] = motionZ;
                swept.x[row] = standing.x[row] - motionX / 2;
                swept.y[row] = standing.y[row] - motionY / 2;
                swept.z[row] = standing.z[row] - motionZ / 2;
                swept.halfX[row] = halfX;
                swept.halfY[row] = halfY;
                swept.halfZ[row] = standing.halfZ[row] + Math.abs(motionZ) / 2;
                swept.radius[row] = Math.sqrt(halfX * halfX + halfY * halfY);
                if (table.shapes[row] != null)
                {
                    bins.fit(swept, row);
                }
            }
        }

        private function makeRows(length:int):void
        {
            if (length > x.length)
            {
                x.length = y.length = z.length = isSweeping.length = length;
                extents.grow(length);
            }
        }
    }
}
