package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.Trigonometry;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.ray.Ray;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Moves an agent as a game character walks. First it slides along the ground. For this slide, surfaces that are too steep are walls. If
     * a wall stops the agent, it tries the same way a step higher, and goes down again. At the end it goes down to the ground, or falls.
     *
     * @private
     */
    public final class WalkQuestions
    {
        // Parts of the extent. CLOSE: the agent stands on ground that is at most this far below it. BEHIND_EDGE: at an edge, the face this far
        // behind the edge is tested. REST: a fall that is less than this is none.
        private static const CLOSE:Number = 1e-6;
        private static const BEHIND_EDGE:Number = 1e-4;
        private static const REST:Number = 1e-8;

        // Ground as steep as the limit is not too steep, although its normal has rounding errors. A fraction of the limit's cosine.
        private static const SLOPE_ROUNDING:Number = 1e-9;

        // In the air every surface is a wall, except level floors.
        private static const FLOOR:Number = 1 - 1e-12;

        // A walk that is longer than the agent goes in pieces of the agent's size, because the ground may be even only so far. Endless walks have
        // no more pieces than this.
        private static const MOST_PIECES:int = 64;

        private var _seen:SeenAgents;
        private var _moves:MoveQuestions;
        private var _mover:Mover;
        private var _rays:RowRays;
        private var _defaults:WalkOptions = new WalkOptions();

        // The walk: its options, and the cosine and the tangent of the steepest slope; the way of a piece, its length, and the place where it
        // begins; the part of the way that the agent has come; how far it slides down after a fall; whether it was in the air at the beginning;
        // its size; the depth of ground that is close; and its lowest point as seen from its place.
        private var _options:WalkOptions;
        private var _cosine:Number = 0;
        private var _tangent:Number = 0;
        private var _dx:Number = 0;
        private var _dy:Number = 0;
        private var _whole:Number = 0;
        private var _start:Vector3D = new Vector3D();
        private var _part:Number = 1;
        private var _slide:Number = 0;
        private var _isInAir:Boolean = false;
        private var _extent:Number = 0;
        private var _close:Number = 0;
        private var _bottom:Number = 0;

        // The place that is reached without a step, the places before and after the way down, and a part of the walk.
        private var _plain:Vector3D = new Vector3D();
        private var _above:Vector3D = new Vector3D();
        private var _below:Vector3D = new Vector3D();
        private var _way:Vector3D = new Vector3D();

        // The ground that was found: its row and its normal.
        private var _row:int = -1;
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
            _rays = new RowRays(seen);
        }

        /** See AgentQueries.walk. */
        public function walk(agent:Agent, dx:Number, dy:Number, options:WalkOptions, out:Footing):Footing
        {
            var asked:WalkOptions = options || _defaults;
            var cosine:Number = (1 - SLOPE_ROUNDING) * Trigonometry.cosine(asked.slopeDegrees);
            var whole:Number = Math.sqrt(dx * dx + dy * dy);
            var size:Number = _seen.placeOf(agent).size;
            var slide:Number = Math.min(asked.fall, size);
            var pieces:int = Math.min(MOST_PIECES, Math.max(1, Math.ceil(whole / size)));
            // on the steepest slope the way is this long
            var reach:Number = whole / cosine + slide / 2;
            _moves.begin(agent, _seen.bodyOfMoving(agent), dx, dy, 0, asked.filter, reach, pieces * asked.stepHeight, pieces * asked.snap + asked.fall);
            var body:Body = _moves.body;
            _options = asked;
            _cosine = cosine;
            _tangent = Math.sqrt(1 - cosine * cosine) / cosine;
            _dx = dx / pieces;
            _dy = dy / pieces;
            _whole = whole / pieces;
            _slide = slide;
            _isInAir = false;
            _extent = 2 * body.largestHalf;
            _close = CLOSE * _extent;
            _mover = _moves.mover;
            _mover.begin(_seen.table, body, _moves.near, 0, _moves.nearCount);
            var stands:Boolean = go(body, pieces);
            _moves.put(agent, _mover.at);
            var footing:Footing = out || new Footing();
            footing.part = _part;
            footing.stands = stands;
            footing.on = stands ? _seen.table.agents[_row] : null;
            if (!stands)
            {
                _normal.setTo(0, 0, 1);
            }
            footing.normal.copyFrom(_normal);
            return footing;
        }

        // Goes all pieces, and falls if the agent does not stand. Returns whether it stands at the end.
        private function go(body:Body, pieces:int):Boolean
        {
            var at:Vector3D = _mover.at;
            var x:Number = at.x;
            var y:Number = at.y;
            var stands:Boolean = false;
            _bottom = body.z - body.halfZ - at.z;
            for (var i:int = 0; i < pieces; i++)
            {
                _start.copyFrom(at);
                stands = goOnGround(i == 0);
            }
            x = at.x - x;
            y = at.y - y;
            _part = _whole > 0 ? Math.min(1, Math.sqrt(x * x + y * y) / (pieces * _whole)) : 1;
            stands ||= body.shape != null && fall();
            _mover.leaveTouches(false);
            return stands;
        }

        // Goes a piece of the way, and down to the ground. A walk that begins in the air stays there. Returns whether the agent stands at the end.
        private function goOnGround(isFirst:Boolean):Boolean
        {
            if (_isInAir && !isFirst || !findStart())
            {
                _isInAir ||= isFirst;
                slide(0, FLOOR);
                return findGround(_close);
            }
            if (_whole == 0)
            {
                // it stays to the bit
                _mover.at.copyFrom(_start);
                return true;
            }
            slide(-(_normal.x * _dx + _normal.y * _dy) / _normal.z, _cosine);
            if (_mover.metWall)
            {
                _plain.copyFrom(_mover.at);
                if (climb())
                {
                    return true;
                }
                _mover.at.copyFrom(_plain);
            }
            return findGround(_options.snap + _close);
        }

        // Finds the ground at the beginning of the walk. If the ground has risen into the agent, the agent comes up to it, by a step at most.
        private function findStart():Boolean
        {
            var stands:Boolean = findGround(_close);
            if (_mover.isDeep)
            {
                goDown(-_options.stepHeight);
                stands = findGround(_options.stepHeight);
                if (stands)
                {
                    _start.z = _mover.at.z;
                }
                _mover.at.z = _start.z;
            }
            return stands;
        }

        private function slide(rise:Number, steepest:Number):void
        {
            _way.setTo(_dx, _dy, rise);
            _mover.go(_way, Mover.SLIDE, steepest, _whole);
        }

        private function goDown(depth:Number):void
        {
            _way.setTo(0, 0, -depth);
            _mover.go(_way, Mover.SHORT);
        }

        // Tries the same way a step higher, and goes down again. Returns whether the agent came farther than without the step, and stands.
        private function climb():Boolean
        {
            _mover.at.copyFrom(_start);
            goDown(-_options.stepHeight);
            var height:Number = _mover.at.z - _start.z;
            if (height <= _close)
            {
                return false;
            }
            slide(0, _cosine);
            var farther:Number = (_mover.at.x - _plain.x) * _dx + (_mover.at.y - _plain.y) * _dy;
            return farther > _close * _whole && findGround(height + _options.snap + _close);
        }

        // Goes down to the ground if it is no deeper than this depth, and not too steep. Returns whether there is such ground.
        private function findGround(depth:Number):Boolean
        {
            _above.copyFrom(_mover.at);
            goDown(depth);
            if (_mover.hasContact && (isLevel(_mover.contact, _mover.contactRow) || isOnAnother()))
            {
                return true;
            }
            _mover.at.copyFrom(_above);
            return false;
        }

        // Whether the agent, which touches something too steep, touches something else that is not.
        private function isOnAnother():Boolean
        {
            _below.copyFrom(_mover.at);
            slideDown(_close);
            _mover.at.copyFrom(_below);
            return _mover.floor.normalZ > -1 && isLevel(_mover.floor, _mover.floorRow);
        }

        private function slideDown(depth:Number):void
        {
            _way.setTo(0, 0, -depth);
            _mover.go(_way, Mover.SLIDE, -2, _slide / 2, _tangent);
        }

        // Falls until something stops the agent, and slides down what is too steep. It falls in pieces that get longer, because rounding
        // errors grow with the length of a motion. If nothing stops an endless fall, it ends where it began. Returns whether the agent stands.
        private function fall():Boolean
        {
            var left:Number = _options.fall;
            _above.copyFrom(_mover.at);
            _mover.hasContact = false;
            for (var piece:Number = 1; left > 0 && !_mover.hasContact; piece *= 2)
            {
                if (piece > Agent.LARGEST_COORDINATE)
                {
                    _mover.at.copyFrom(_above);
                    return false;
                }
                goDown(Math.min(left, piece));
                left -= _mover.part * Math.min(left, piece);
            }
            if (!_mover.hasContact || isLevel(_mover.contact, _mover.contactRow))
            {
                return _mover.hasContact;
            }
            slideDown(Math.min(left, _slide));
            if (_above.z - _mover.at.z < REST * _extent)
            {
                _mover.at.copyFrom(_above);
            }
            return findGround(_close);
        }

        // Whether the surface that stopped the way down is not too steep. At an edge, for example of a step, the face behind the edge
        // decides. But the edge must not be more than a step higher than the agent was at the beginning of the walk, or is now.
        private function isLevel(contact:ContactPoint, row:int):Boolean
        {
            _row = row;
            _normal.setTo(contact.normalX, contact.normalY, contact.normalZ);
            if (_normal.z >= _cosine)
            {
                return true;
            }
            if (contact.z > Math.min(_start.z, _mover.at.z) + _bottom + _options.stepHeight + _close)
            {
                return false;
            }
            var across:Number = Math.sqrt(_normal.x * _normal.x + _normal.y * _normal.y);
            var behind:Number = BEHIND_EDGE * _extent;
            // the ray begins outside of all faces that are not too steep
            var above:Number = 2 * behind / _cosine;
            _origin.setTo(contact.x - behind * _normal.x / across, contact.y - behind * _normal.y / across, contact.z + above);
            var ray:Ray = _rays.ray;
            ray.aim(_origin, _down);
            ray.to = 2 * above;
            if (!_rays.meets(row) || ray.from == 0)
            {
                return false;
            }
            _normal.setTo(ray.normalX, ray.normalY, ray.normalZ);
            return _normal.z >= _cosine;
        }
    }
}
