package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.agents.PlatformLink;
    import starlogo.bounding.BoundingStructure;
    import starlogo.collision.Contact;
    import starlogo.convex.ContactPoint;
    import starlogo.engine;
    import starlogo.geometry.Trigonometry;
    import starlogo.geometry.copyVector;
    import starlogo.queries.motion.MotionResult;
    import starlogo.queries.motion.MovingBody;
    import starlogo.queries.motion.OverlapRecovery;
    import starlogo.queries.motion.SlideLimits;
    import starlogo.queries.motion.SlideResult;
    import starlogo.queries.motion.Slider;
    import starlogo.queries.motion.TouchSweep;
    import starlogo.queries.motion.Walk;
    import starlogo.queries.motion.WalkMover;
    import starlogo.queries.rays.Hits;
    import starlogo.queries.rays.SpareHits;
    import starlogo.queries.trees.Collector;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * Answers how far an agent or a structure can go, and where a character that walks comes to stand. Some questions move the agent there. The casts
     * move nothing. AgentMotions says what each question means.
     *
     * @private
     */
    public final class MoveQueries
    {
        // Ground as steep as the limit is not too steep, although its normal has rounding errors. A fraction of the limit's cosine.
        private static const SLOPE_ROUNDING:Number = 1e-9;

        // A leg of a walk is as long as the agent, or longer if the walk would have more legs than this.
        private static const MAX_LEGS:int = 64;

        private static const UP:Vector3D = new Vector3D(0, 0, 1);

        private static const DEFAULTS:WalkOptions = new WalkOptions();

        private var _seen:SeenAgents;

        private var _slider:Slider = new Slider();
        private var _recovery:OverlapRecovery = new OverlapRecovery();
        private var _walkMover:WalkMover;
        private var _sweep:TouchSweep;
        private var _hits:Hits;
        private var _spare:SpareHits = new SpareHits(ShapeHit);

        // The body of a question, and the walk of a question.
        private var _bodies:PerQuestion;
        private var _walks:PerQuestion;

        // How a motion ends at the first row that stops it, and how a slide ends.
        private var _first:MotionResult = new MotionResult();
        private var _slid:SlideResult = new SlideResult();

        /** @param seen the agents that the questions are about */
        public function MoveQueries(seen:SeenAgents)
        {
            _seen = seen;
            _sweep = new TouchSweep(seen);
            _hits = new Hits(seen);
            _bodies = new PerQuestion(seen, MovingBody);
            _walkMover = new WalkMover(seen);
            _walks = new PerQuestion(seen, Walk);
        }

        /** See AgentMotions.castShape. */
        public function castShape(structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter, hit:ShapeHit):ShapeHit
        {
            return cast(currentBody().setToStructure(structure).aim(dx, dy, dz), filter, hit);
        }

        /** See AgentMotions.castShapeAll. */
        public function castShapeAll(structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter,
                out:Vector.<ShapeHit>):Vector.<ShapeHit>
        {
            return castAll(currentBody().setToStructure(structure).aim(dx, dy, dz), filter, out);
        }

        /** See AgentMotions.castAgent. */
        public function castAgent(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, hit:ShapeHit):ShapeHit
        {
            return cast(currentBody().setToCastAgent(agent).aim(dx, dy, dz), filter, hit);
        }

        /** See AgentMotions.castAgentAll. */
        public function castAgentAll(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, out:Vector.<ShapeHit>):Vector.<ShapeHit>
        {
            return castAll(currentBody().setToCastAgent(agent).aim(dx, dy, dz), filter, out);
        }

        /** See AgentMotions.moveUntilTouch. */
        public function moveUntilTouch(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, contact:Contact):Number
        {
            _seen.requireMovable(agent, "moveUntilTouch");
            var body:MovingBody = currentBody().setToAgent(agent).aim(dx, dy, dz);
            findStops(body, filter, 1, _first);
            if (_first.isStopped)
            {
                _sweep.moveIntoTouch(body, _first);
            }
            // before the contact is written, because an agent that would leave the world throws an error
            if (dx != 0 || dy != 0 || dz != 0)
            {
                _seen.moveAgent(agent, _first.place);
            }
            if (contact != null)
            {
                contact.time = _first.time;
                if (_first.isStopped)
                {
                    contact.setFromPoint(_first.contact);
                    contact.approachSpeed = Math.max(0, -_first.contact.along(body.motion));
                }
            }
            return _first.time;
        }

        /** See AgentMotions.slide. */
        public function slide(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter):Number
        {
            return moveSliding(agent, dx, dy, dz, filter, SlideLimits.NONE);
        }

        /** Slides, but at the agent's height: a slope is an upright wall. The errors are those of <code>slide()</code>. */
        public function slideLevel(agent:Agent, dx:Number, dy:Number, filter:AgentFilter):Number
        {
            return moveSliding(agent, dx, dy, 0, filter, SlideLimits.LEVEL);
        }

        /** See AgentMotions.walk. */
        public function walk(agent:Agent, dx:Number, dy:Number, options:WalkOptions, out:Footing):Footing
        {
            _seen.requireMovable(agent, "walk");
            var walk:Walk = findWalk(agent, dx, dy, options || DEFAULTS);
            // before the footing is written, because an agent that would leave the world throws an error
            _seen.moveAgent(agent, walk.place, walk.carryTurn);
            var footing:Footing = out || new Footing();
            footing.copyFrom(walk.footing);
            var link:PlatformLink = agent.platformLink;
            link.platform = null;
            if (footing.stands && walk.floorRow >= ListedAgents.FIRST_LISTED)
            {
                link.setTo(footing.on, _seen.table.bodyOf(walk.floorRow).placement, _seen.table.revisions[walk.floorRow]);
            }
            return footing;
        }

        /**
         * Finds the footing that a walk without a way would give the agent now. Nothing moves, but an agent that has never walked gets an empty
         * PlatformLink. It may be asked in a filter's <code>accepts</code>.
         */
        public function findFooting(agent:Agent, options:WalkOptions, out:Footing):Footing
        {
            out.copyFrom(findWalk(agent, 0, 0, options).footing);
            return out;
        }

        // Finds where a walk leads, and on what the agent stands there. Nothing moves. An agent without a PlatformLink gets an empty one.
        private function findWalk(agent:Agent, dx:Number, dy:Number, options:WalkOptions):Walk
        {
            var walk:Walk = Walk(_walks.current);
            readOptions(agent, dx, dy, options, walk);
            agent.platformLink ||= new PlatformLink(agent);
            var footing:Footing = walk.footing;
            footing.stands = _walkMover.go(agent.platformLink, walk);
            var agents:Vector.<Agent> = _seen.table.list.agentsByRow;
            footing.on = footing.stands ? agents[walk.floorRow] : null;
            footing.against = walk.wallRow >= 0 ? agents[walk.wallRow] : null;
            copyVector(footing.stands ? walk.floorNormal : UP, footing.normal);
            return walk;
        }

        // Finds what the motion and the options mean for the agent.
        private function readOptions(agent:Agent, dx:Number, dy:Number, options:WalkOptions, out:Walk):void
        {
            var size:Number = _seen.placementOf(agent).size;
            requireMotion(dx, dy, 0, agent);
            var length:Number = Math.sqrt(dx * dx + dy * dy);
            out.options = options;
            out.walkableZ = (1 - SLOPE_ROUNDING) * Trigonometry.cosine(options.slopeDegrees);
            out.legCount = Math.min(MAX_LEGS, Math.max(1, Math.ceil(length / size)));
            out.legMotion.setTo(dx / out.legCount, dy / out.legCount, 0);
            out.legLength = length / out.legCount;
        }

        // The body of the question that begins now.
        private function currentBody():MovingBody
        {
            return MovingBody(_bodies.current);
        }

        private function moveSliding(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, limits:SlideLimits):Number
        {
            _seen.requireMovable(agent, "slide");
            var body:MovingBody = currentBody().setToAgent(agent).aim(dx, dy, dz);
            body.collectRowsWithin(body.motion.length, 0, 0, filter);
            _slider.slide(body, body.rows, body.from, body.motion, limits, _slid);
            _recovery.restoreClearance(body, _slid.place);
            if (limits.staysLevel)
            {
                // the clearance leads off slopes by their normals
                _slid.place.z = body.from.z;
            }
            if (dx != 0 || dy != 0 || dz != 0)
            {
                _seen.moveAgent(agent, _slid.place);
            }
            return _slid.fraction;
        }

        private function cast(body:MovingBody, filter:AgentFilter, hit:ShapeHit):ShapeHit
        {
            return findStops(body, filter, 1, _first) == 0 ? null : fillHit(0, hit || new ShapeHit());
        }

        private function castAll(body:MovingBody, filter:AgentFilter, out:Vector.<ShapeHit>):Vector.<ShapeHit>
        {
            var hits:Vector.<ShapeHit> = out || new Vector.<ShapeHit>();
            _spare.resize(hits, findStops(body, filter, Collector.ALL, _first));
            for (var i:int = 0; i < hits.length; i++)
            {
                fillHit(i, hits[i]);
            }
            return hits;
        }

        // Finds the rows that stop a body on a straight way, each as if the others were not there. The filter's accepts is called first, because it may ask
        // other questions, which use the same hits. Returns how many hits there are.
        private function findStops(body:MovingBody, filter:AgentFilter, maxCount:int, first:MotionResult):int
        {
            body.collectRowsAlong(filter);
            return _hits.end(_sweep.findTouches(body, maxCount, _hits, first));
        }

        // Writes how the body touches a row of the answer.
        private function fillHit(index:int, hit:ShapeHit):ShapeHit
        {
            var body:Body = _hits.bodyOf(index);
            var contact:ContactPoint = _hits.contactOf(index);
            if (body.form != ModelShape.TREE)
            {
                // it may be a triangle of what is cast
                contact.triangle = -1;
            }
            else if (contact.triangle < 0)
            {
                contact.triangle = _seen.narrowPhase.treeTests.findNearestTriangle(body, contact);
            }
            _hits.fillHit(index, hit);
            hit.time = _hits.keyOf(index);
            return hit;
        }
    }
}
