package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.Trigonometry;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.search.AgentTable;

    use namespace engine;

    /**
     * Moves an agent as a game character walks. First it slides along the ground. For this slide, surfaces that are too steep are walls. If
     * a wall stops the agent, it tries the same way a step higher, and goes down again. At the end it goes down to the ground.
     *
     * @private
     */
    public final class WalkQuestions
    {
        // Both are parts of the extent. CLOSE: the agent stands on ground that is at most this far below it. BEHIND_EDGE: at an edge, the
        // face this far behind the edge is tested.
        private static const CLOSE:Number = 1e-6;
        private static const BEHIND_EDGE:Number = 1e-4;

        private var _seen:SeenAgents;
        private var _moves:MoveQuestions;
        private var _mover:Mover;
        private var _defaults:WalkOptions = new WalkOptions();
        private var _rays:RowRays = new RowRays();

        // The options of the walk under way. The cosine and the tangent belong to the steepest slope.
        private var _step:Number = 0;
        private var _snap:Number = 0;
        private var _cosine:Number = 0;
        private var _tangent:Number = 0;

        // The greatest height of an edge that it can stand on.
        private var _highest:Number = 0;

        // The walk; the place where it begins; the place that it reaches without a step; and the size of the agent.
        private var _dx:Number = 0;
        private var _dy:Number = 0;
        private var _start:Vector3D = new Vector3D();
        private var _plain:Vector3D = new Vector3D();
        private var _extent:Number = 0;

        // A part of the walk, and the place where this part begins.
        private var _way:Vector3D = new Vector3D();
        private var _from:Vector3D = new Vector3D();

        // The normal of the ground that was found.
        private var _normal:Vector3D = new Vector3D();

        private var _origin:Vector3D = new Vector3D();
        private var _down:Vector3D = new Vector3D(0, 0, -1);

        /**
         * @param seen the agents that are asked about
         * @param moves finds the agents near the way
         */
        public function WalkQuestions(seen:SeenAgents, moves:MoveQuestions)
        {
            _seen = seen;
            _moves = moves;
        }

        /** See AgentQueries.walk. */
        public function walk(agent:Agent, dx:Number, dy:Number, options:WalkOptions, out:Footing):Footing
        {
            if (!isFinite(dx) || !isFinite(dy))
            {
                throw new RangeError("a motion must be finite: (" + dx + ", " + dy + ")");
            }
            options ||= _defaults;
            var footing:Footing = out || new Footing();
            var step:Number = options.stepHeight;
            var snap:Number = options.snap;
            var slope:Number = options.slopeDegrees;
            _moves.way.setTo(Math.abs(dx) + Math.abs(dy), 0, 2 * step + snap);
            var row:int = _moves.begin(agent, null, options.filter, true);
            // the filter may have asked for other walks, which set these fields
            _step = step;
            _snap = snap;
            _cosine = Trigonometry.cosine(slope);
            _tangent = Trigonometry.sine(slope) / _cosine;
            _dx = dx;
            _dy = dy;
            var table:AgentTable = _seen.table;
            _mover = _moves.mover;
            if (table.shapes[row] == null)
            {
                _start.setTo(agent.x, agent.y, agent.z);
                _mover.at.setTo(agent.x + dx, agent.y + dy, agent.z);
                setFooting(footing, false);
            }
            else
            {
                _extent = 2 * table.extents.largestHalf(row);
                _highest = table.extents.z[row] - table.extents.halfZ[row] + step + CLOSE * _extent;
                _mover.begin(table, row, _moves.agents, _moves.way);
                var stands:Boolean = goOnGround();
                _mover.leaveTouches();
                setFooting(footing, stands);
                _mover.end();
            }
            table.endGuests();
            _moves.put(agent);
            return footing;
        }

        // Walks among the agents near the way. Returns whether the agent stands at the end.
        private function goOnGround():Boolean
        {
            var close:Number = CLOSE * _extent;
            _start.copyFrom(_mover.at);
            var stood:Boolean = findGround(close);
            _mover.at.copyFrom(_start);
            var rise:Number = 0;
            if (stood)
            {
                rise = -(_normal.x * _dx + _normal.y * _dy) / _normal.z;
            }
            slide(rise);
            if (stood && _mover.metWall && _step > 0)
            {
                _plain.copyFrom(_mover.at);
                if (!climb(close))
                {
                    _mover.at.copyFrom(_plain);
                }
            }
            return findGround(stood ? Math.max(_snap, close) : close);
        }

        private function slide(rise:Number):void
        {
            _way.setTo(_dx, _dy, rise);
            _mover.steepest = _cosine;
            _mover.go(_way, Mover.SLIDE);
            _mover.steepest = Mover.NOTHING_STEEP;
        }

        // Tries the same way a step higher, and goes down again. Returns whether the agent came farther than without the step, and stands.
        private function climb(close:Number):Boolean
        {
            _mover.at.copyFrom(_start);
            _way.setTo(0, 0, _step);
            _mover.go(_way, Mover.SHORT);
            var height:Number = _mover.at.z - _start.z;
            if (height <= close)
            {
                return false;
            }
            slide(0);
            return progressOf(_mover.at) > progressOf(_plain) + close && findGround(height + Math.max(_snap, close));
        }

        private function progressOf(place:Vector3D):Number
        {
            return ((place.x - _start.x) * _dx + (place.y - _start.y) * _dy) / Math.sqrt(_dx * _dx + _dy * _dy);
        }

        // Goes down to the ground if it is no deeper than this depth, and not too steep. Returns whether there is such ground.
        private function findGround(depth:Number):Boolean
        {
            _from.copyFrom(_mover.at);
            _way.setTo(0, 0, -depth);
            _mover.go(_way, Mover.SHORT);
            if (_mover.hasContact && isLevel(_mover.contact))
            {
                return true;
            }
            _mover.at.copyFrom(_from);
            return false;
        }

        // Whether the surface that stopped the way down is not too steep. At an edge, for example of a step, the face behind the edge
        // decides. But the edge must not be more than a step higher than the beginning of the walk.
        private function isLevel(contact:ContactPoint):Boolean
        {
            _normal.setTo(contact.normalX, contact.normalY, contact.normalZ);
            if (_normal.z >= _cosine)
            {
                return true;
            }
            if (contact.z > _highest)
            {
                return false;
            }
            var across:Number = Math.sqrt(_normal.x * _normal.x + _normal.y * _normal.y);
            var behind:Number = BEHIND_EDGE * _extent;
            // the ray begins outside of all faces that are not too steep
            var above:Number = 1.01 * behind * (_tangent + 1);
            _origin.setTo(contact.x - behind * _normal.x / across, contact.y - behind * _normal.y / across, contact.z + above);
            _rays.ray.aim(_origin, _down);
            _rays.limit = 2 * above;
            _rays.begin(_seen.table, _seen.pairs.trees);
            if (!_rays.meets(_mover.contactRow) || _rays.distance == 0 || _rays.normalZ < _cosine)
            {
                return false;
            }
            _normal.setTo(_rays.normalX, _rays.normalY, _rays.normalZ);
            return true;
        }

        private function setFooting(footing:Footing, stands:Boolean):void
        {
            var whole:Number = Math.sqrt(_dx * _dx + _dy * _dy);
            var x:Number = _mover.at.x - _start.x;
            var y:Number = _mover.at.y - _start.y;
            footing.stands = stands;
            footing.on = stands ? _seen.table.agents[_mover.contactRow] : null;
            footing.normal.setTo(0, 0, 1);
            if (stands)
            {
                footing.normal.copyFrom(_normal);
            }
            footing.part = whole > 0 ? Math.min(1, Math.sqrt(x * x + y * y) / whole) : 1;
        }
    }
}
