package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.agents.PlatformLink;
    import starlogo.convex.ContactPoint;
    import starlogo.data.NumberList;
    import starlogo.engine;
    import starlogo.geometry.Trigonometry;
    import starlogo.geometry.requireInWorld;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayEntry;
    import starlogo.queries.motion.MotionPlanner;
    import starlogo.queries.motion.MotionResult;
    import starlogo.queries.motion.Mover;
    import starlogo.queries.motion.SlideLimits;
    import starlogo.queries.motion.SlideResult;
    import starlogo.queries.rays.RowRays;
    import starlogo.search.Body;
    import starlogo.search.table.AgentTable;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * Moves an agent as a game character walks. First it slides along the ground. For this slide, surfaces that are too steep are walls. If
     * a wall stops the agent, it tries the same way a step higher, and goes down again. At the end it goes down to the ground, or falls.
     *
     * @private
     */
    public final class WalkQueries
    {
        // Parts of the extent. CLOSE: the agent stands on ground that is at most this far below it. BEHIND_EDGE: at an edge, the face this far
        // behind the edge is tested. REST: a shorter fall counts as none, and is undone.
        private static const CLOSE:Number = 1e-6;
        private static const BEHIND_EDGE:Number = 1e-4;
        private static const REST:Number = 1e-8;

        // Ground as steep as the limit is not too steep, although its normal has rounding errors. A fraction of the limit's cosine.
        private static const SLOPE_ROUNDING:Number = 1e-9;

        // In the air every surface is a wall, except level floors.
        private static const FLOOR:Number = 1 - 1e-12;

        // A piece of a walk is as long as the agent. Endless walks have no more pieces than this.
        private static const MOST_PIECES:int = 64;

        // A walk begins with this many pushes at most.
        private static const MOST_PUSHES:int = 8;

        private static const DEFAULTS:WalkOptions = new WalkOptions();
        private static const DOWN:Vector3D = new Vector3D(0, 0, -1);

        private var _seen:SeenAgents;
        private var _planner:MotionPlanner;
        private var _rowRays:RowRays;
        private var _mover:Mover;
        private var _walk:Walk = new Walk();
        private var _overlap:ContactPoint = new ContactPoint();
        private var _limits:SlideLimits = new SlideLimits();
        private var _ray:Ray = new Ray();
        private var _entry:RayEntry = new RayEntry();

        // How a slide along the ground ends.
        private var _slide:SlideResult = new SlideResult();

        // How a slide ends that is tried in its place, or that leads down a slope.
        private var _tried:SlideResult = new SlideResult();

        // How the last way down ends.
        private var _down:MotionResult = new MotionResult();

        // How another straight way ends.
        private var _straight:MotionResult = new MotionResult();

        // The rows near the walk without the platform.
        private var _others:NumberList = new NumberList();

        // The vector of a motion, and the beginning of a motion or of a ray.
        private var _vector:Vector3D = new Vector3D();
        private var _origin:Vector3D = new Vector3D();

        // Answers what an accepts asks while these questions call it.
        private var _nested:WalkQueries = null;

        /** @param seen the agents that the questions are about */
        public function WalkQueries(seen:SeenAgents)
        {
            _seen = seen;
            _planner = new MotionPlanner(seen);
            _mover = new Mover(seen);
            _rowRays = new RowRays(seen);
        }

        /** See AgentQueries.walk. */
        public function walk(agent:Agent, dx:Number, dy:Number, options:WalkOptions, out:Footing):Footing
        {
            _seen.requireMovable(agent, "walk");
            return idle.walkOn(agent, dx, dy, options || DEFAULTS, out || new Footing());
        }

        // These questions, or the nested ones while a filter's accepts is being called.
        private function get idle():WalkQueries
        {
            return _planner.isAsking ? (_nested ||= new WalkQueries(_seen)).idle : this;
        }

        private function walkOn(agent:Agent, dx:Number, dy:Number, options:WalkOptions, footing:Footing):Footing
        {
            var walk:Walk = _walk;
            readOptions(agent, dx, dy, options, walk);
            var link:PlatformLink = agent.platformLink ||= new PlatformLink(agent);
            begin(walk, findPlatform(walk, link));
            var stands:Boolean = goPieces(walk);
            // before the footing is written, because an agent that would leave the world throws an error
            _planner.moveAgent(agent, walk.place, walk.turn);
            footing.stands = stands;
            footing.part = walk.part;
            footing.pushed = walk.pushed;
            if (!stands)
            {
                walk.floorRow = -1;
                walk.floorNormal.setTo(0, 0, 1);
            }
            var table:AgentTable = _seen.table;
            footing.on = walk.floorRow < 0 ? null : table.list.agents[walk.floorRow];
            footing.normal.copyFrom(walk.floorNormal);
            link.platform = null;
            if (walk.floorRow >= ListedAgents.FIRST_LISTED)
            {
                link.setTo(footing.on, table.bodyOf(walk.floorRow).placement, table.places.last.revisions[walk.floorRow]);
            }
            return footing;
        }

        // Finds what the motion and the options mean for the agent.
        private function readOptions(agent:Agent, dx:Number, dy:Number, options:WalkOptions, out:Walk):void
        {
            var size:Number = _seen.placeOf(agent).size;
            requireInWorld("a motion", dx, dy, 0);
            var whole:Number = Math.sqrt(dx * dx + dy * dy);
            out.agent = agent;
            out.options = options;
            out.cosine = (1 - SLOPE_ROUNDING) * Trigonometry.cosine(options.slopeDegrees);
            out.pieces = Math.min(MOST_PIECES, Math.max(1, Math.ceil(whole / size)));
            out.piece.setTo(dx / out.pieces, dy / out.pieces, 0);
            out.pieceLength = whole / out.pieces;
            // on the steepest slope the way is this long
            out.range = whole / out.cosine + Math.min(options.fall, size) / 2;
        }

        // Finds the rows near the walk, and lets a platform carry the agent: its row, or -1.
        private function begin(walk:Walk, platform:int):void
        {
            walk.range += walk.carry.length;
            _planner.readBody(walk.agent, walk.turn, walk.planned.body);
            findNear(walk, 0);
            walk.extent = 2 * walk.planned.body.largestHalf;
            walk.closeDepth = CLOSE * walk.extent;
            walk.start.copyFrom(walk.planned.from);
            if (platform >= 0)
            {
                carryWith(platform, walk);
            }
            _mover.setBody(walk.planned.body, walk.planned.rows);
        }

        // Returns the row of the agent below if it carries the agent, or -1: if it has moved since the last walk, and the filter does not exclude
        // it. The walk receives how it carries the agent.
        private function findPlatform(walk:Walk, link:PlatformLink):int
        {
            var row:int = walk.options.carried && link.isValid ? _seen.rowOf(link.platform) : -1;
            if (row >= 0 && _seen.table.shapes[row] != null)
            {
                walk.turn = link.carry(_seen.table.bodyOf(row).placement, walk.carry);
                if ((walk.turn != 0 || walk.carry.length > 0) && _planner.askFilter(row, walk.agent, walk.options.filter))
                {
                    return row;
                }
            }
            walk.carry.setTo(0, 0, 0);
            walk.turn = 0;
            return -1;
        }

        // Carries the agent with the platform. It slides along others that are in its way, but not into the platform. The platform has moved
        // already, so only the rest of its way, which the agent misses, can lead into it.
        private function carryWith(platform:int, walk:Walk):void
        {
            _others.copyFrom(walk.planned.rows, platform);
            _mover.setBody(walk.planned.body, _others);
            _mover.slide(walk.start, walk.carry, SlideLimits.NONE, walk.setup, _slide);
            if (_slide.fraction < 1 && leadsIntoPlatform(platform, walk, _slide.place))
            {
                _mover.goBeforeTouch(walk.start, walk.carry, walk.setup, _straight);
                if (!leadsIntoPlatform(platform, walk, _straight.place))
                {
                    _slide.place.copyFrom(_straight.place);
                }
            }
            walk.start.copyFrom(_slide.place);
        }

        // Whether the rest of the way that the platform carries the agent, from its end back to a place, leads into the platform.
        private function leadsIntoPlatform(platform:int, walk:Walk, place:Vector3D):Boolean
        {
            _origin.copyFrom(walk.start);
            _origin.incrementBy(walk.carry);
            _vector.copyFrom(place);
            _vector.decrementBy(_origin);
            return _mover.meets(platform, _origin, _vector);
        }

        // Finds the rows near the walk, and up to a distance from it.
        private function findNear(walk:Walk, distance:Number):void
        {
            var options:WalkOptions = walk.options;
            // the range has the way in it, whatever its direction
            _planner.planWithin(walk.agent, walk.range + distance, walk.pieces * options.stepHeight, walk.pieces * options.snap + options.fall,
                    options.filter, walk.planned);
        }

        // Pushes the agent out of what it overlaps, goes all pieces, and falls if the agent does not stand. Returns whether it stands at the end.
        // The walk receives how far the agent was pushed, and which part of the motion it has made.
        private function goPieces(walk:Walk):Boolean
        {
            var stands:Boolean = goDown(walk, walk.start, walk.closeDepth);
            walk.pushed = 0;
            if (_down.isDeep)
            {
                walk.pushed = pushOut(walk);
                stands = goDown(walk, walk.start, walk.closeDepth);
            }
            // a walk that begins in the air stays there
            var isInAir:Boolean = !stands;
            var startX:Number = walk.start.x;
            var startY:Number = walk.start.y;
            for (var i:int = 0; i < walk.pieces; i++)
            {
                if (i > 0)
                {
                    walk.start.copyFrom(walk.place);
                    stands = !isInAir && goDown(walk, walk.start, walk.closeDepth);
                }
                stands = goPiece(walk, stands);
            }
            var dx:Number = walk.place.x - startX;
            var dy:Number = walk.place.y - startY;
            walk.part = walk.pieceLength > 0 ? Math.min(1, Math.sqrt(dx * dx + dy * dy) / (walk.pieces * walk.pieceLength)) : 1;
            stands ||= walk.planned.body.shape != null && fall(walk);
            _mover.restoreClearance(walk.place, walk.setup, -1);
            return stands;
        }

        // Pushes the agent out of what it overlaps, the deepest overlap first. A push is a slide, so it leads through nothing else. Returns how far.
        private function pushOut(walk:Walk):Number
        {
            var left:Number = _mover.findDeepest(walk.start, walk.setup, _overlap);
            if (left == 0)
            {
                return 0;
            }
            findNear(walk, left);
            _mover.setBody(walk.planned.body, walk.planned.rows);
            _slide.place.copyFrom(walk.start);
            for (var i:int = 0; i < MOST_PUSHES && left > 0 && _mover.findDeepest(_slide.place, walk.setup, _overlap) > 0; i++)
            {
                var length:Number = Math.min(left, _overlap.depth);
                left -= length;
                _vector.setTo(0, 0, 0);
                _overlap.push(_vector, length);
                _mover.slide(_slide.place, _vector, SlideLimits.NONE, walk.setup, _slide);
            }
            _vector.copyFrom(_slide.place);
            _vector.decrementBy(walk.start);
            walk.start.copyFrom(_slide.place);
            return _vector.length;
        }

        // Goes a piece of the way, and down to the ground. Returns whether the agent stands at the end.
        private function goPiece(walk:Walk, stands:Boolean):Boolean
        {
            if (!stands)
            {
                // the fall finds whether it stands
                slide(walk, walk.start, 0, FLOOR, _slide);
                walk.place.copyFrom(_slide.place);
                return false;
            }
            if (walk.pieceLength == 0)
            {
                // it stays exactly where it is
                walk.place.copyFrom(walk.start);
                return true;
            }
            var rise:Number = -(walk.floorNormal.x * walk.piece.x + walk.floorNormal.y * walk.piece.y) / walk.floorNormal.z;
            slide(walk, walk.place, rise, walk.cosine, _slide);
            if (_slide.metWall && climb(walk, _slide.place))
            {
                return true;
            }
            walk.place.copyFrom(_slide.place);
            return goDown(walk, walk.place, walk.options.snap + walk.closeDepth);
        }

        // Slides along the way of a piece, and up or down.
        private function slide(walk:Walk, from:Vector3D, rise:Number, walkableZ:Number, out:SlideResult):void
        {
            _limits.setTo(walkableZ, walk.pieceLength, -1);
            _vector.setTo(walk.piece.x, walk.piece.y, rise);
            _mover.slide(from, _vector, _limits, walk.setup, out);
        }

        // Goes straight up, or down if dz is less than 0, until something is in the way.
        private function goUpright(walk:Walk, from:Vector3D, dz:Number, out:MotionResult):void
        {
            _vector.setTo(0, 0, dz);
            _mover.goBeforeTouch(from, _vector, walk.setup, out);
        }

        // Tries the same way a step higher, and goes down again. If the agent comes farther than without the step, and stands, the walk is there.
        // Returns whether it does.
        private function climb(walk:Walk, plain:Vector3D):Boolean
        {
            goUpright(walk, walk.start, walk.options.stepHeight, _straight);
            var height:Number = _straight.place.z - walk.start.z;
            if (height <= walk.closeDepth)
            {
                return false;
            }
            slide(walk, _straight.place, 0, walk.cosine, _tried);
            var farther:Number = (_tried.place.x - plain.x) * walk.piece.x + (_tried.place.y - plain.y) * walk.piece.y;
            return farther > walk.closeDepth * walk.pieceLength && goDown(walk, _tried.place, height + walk.options.snap + walk.closeDepth);
        }

        // Goes down to the ground if it is no deeper than this depth, and not too steep. If there is such ground, the walk is there. Otherwise it
        // is at the beginning. Returns whether there is. _down receives how the motion down ends.
        private function goDown(walk:Walk, from:Vector3D, depth:Number):Boolean
        {
            // copied, because the beginning may be the place of a result that is overwritten here
            walk.place.copyFrom(from);
            goUpright(walk, walk.place, -depth, _down);
            if (_down.row < 0 || !(standOn(walk, _down.contact, _down.row, _down.place) || standOnOther(walk, _down.place)))
            {
                return false;
            }
            walk.place.copyFrom(_down.place);
            return true;
        }

        // Lets the agent stand on what else it touches at a place, besides something too steep. Returns whether it does.
        private function standOnOther(walk:Walk, place:Vector3D):Boolean
        {
            slideDown(walk, place, walk.closeDepth, walk.extent, _tried);
            return _tried.floorRow >= 0 && _tried.floor.normalZ > -1 && standOn(walk, _tried.floor, _tried.floorRow, place);
        }

        private function slideDown(walk:Walk, from:Vector3D, depth:Number, maxHorizontal:Number, out:SlideResult):void
        {
            _limits.setTo(-2, maxHorizontal, Math.sqrt(1 - walk.cosine * walk.cosine) / walk.cosine);
            _vector.setTo(0, 0, -depth);
            _mover.slide(from, _vector, _limits, walk.setup, out);
        }

        // Falls until something stops the agent, and slides down what is too steep. It falls in pieces that get longer, because rounding
        // errors grow with the length of a motion. If nothing stops an endless fall, it ends where it began. Returns whether the agent stands.
        private function fall(walk:Walk):Boolean
        {
            var left:Number = walk.options.fall;
            _down.place.copyFrom(walk.place);
            _down.row = -1;
            for (var piece:Number = 1; left > 0 && _down.row < 0; piece *= 2)
            {
                if (_down.place.z - Math.min(left, piece) < -Agent.LARGEST_COORDINATE)
                {
                    return false;
                }
                goUpright(walk, _down.place, -Math.min(left, piece), _down);
                left -= _down.fraction * Math.min(left, piece);
            }
            if (_down.row < 0)
            {
                // a fall can also end where the ground begins, without being stopped
                return goDown(walk, _down.place, walk.closeDepth);
            }
            if (standOn(walk, _down.contact, _down.row, _down.place))
            {
                walk.place.copyFrom(_down.place);
                return true;
            }
            var longest:Number = Math.min(walk.options.fall, walk.planned.body.placement.size);
            slideDown(walk, _down.place, Math.min(left, longest), longest / 2, _tried);
            return goDown(walk, walk.place.z - _tried.place.z < REST * walk.extent ? walk.place : _tried.place, walk.closeDepth);
        }

        // Lets the agent stand on the surface at a contact below it, if the surface is not too steep. At an edge, for example of a step, the face
        // behind the edge is the surface. But the edge must not be more than a step higher than the agent was at the beginning of the piece, or is
        // at its place. The walk receives the surface. Returns whether the agent stands.
        private function standOn(walk:Walk, contact:ContactPoint, row:int, place:Vector3D):Boolean
        {
            if (contact.normalZ >= walk.cosine)
            {
                walk.floorRow = row;
                walk.floorNormal.setTo(contact.normalX, contact.normalY, contact.normalZ);
                return true;
            }
            var body:Body = walk.planned.body;
            var bottom:Number = body.z - body.halfZ - body.placement.z;
            if (contact.z > Math.min(walk.start.z, place.z) + bottom + walk.options.stepHeight + walk.closeDepth)
            {
                return false;
            }
            var across:Number = Math.sqrt(contact.normalX * contact.normalX + contact.normalY * contact.normalY);
            var behind:Number = BEHIND_EDGE * walk.extent;
            // the ray begins outside of all faces that are not too steep
            var above:Number = 2 * behind / walk.cosine;
            _origin.setTo(contact.x - behind * contact.normalX / across, contact.y - behind * contact.normalY / across, contact.z + above);
            _ray.aim(_origin, DOWN);
            _ray.to = 2 * above;
            if (!_rowRays.findHit(row, _ray, _entry) || _entry.distance == 0 || !(_entry.normalZ >= walk.cosine))
            {
                return false;
            }
            walk.floorRow = row;
            walk.floorNormal.setTo(_entry.normalX, _entry.normalY, _entry.normalZ);
            return true;
        }
    }
}
