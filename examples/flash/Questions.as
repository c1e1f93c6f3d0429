package
{
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.AgentQueries;

    /** Questions about space: The wolf sees a slice of the meadow. Sheep in it turn orange, and the nearest has a ring. You lead the wolf. */
    [SWF(width="600", height="400", frameRate="60", backgroundColor="#eef1ee")]
    public class Questions extends Land
    {
        private var _wolf:Agent = make("sphere", "wolves", 1.3, BLUE);
        private var _agents:Vector.<Agent> = new <Agent>[_wolf];
        private var _queries:AgentQueries = new AgentQueries(new BinCollider());
        private var _sheep:AgentFilter = AgentFilter.ofBreeds("sheep");

        public function Questions()
        {
            for (var i:int = 0; i < 70; i++)
            {
                _agents.push(make("sphere", "sheep", 0.8, 0xffffff));
            }
        }

        override protected function step():void
        {
            follow(_wolf, 0.1);
            _queries.update(_agents); // once a frame, after the agents have moved

            var seen:Vector.<Agent> = _queries.inCone(_wolf, 7, 70, _sheep); // within 7 patches, 35 degrees to either side
            var near:Vector.<Agent> = _queries.near(_wolf, 3, _sheep);
            var nearest:Agent = _queries.nearest(_wolf, Infinity, _sheep);

            for (var i:int = 1; i < _agents.length; i++)
            {
                _agents[i].color = 0xffffff;
                walk(_agents[i], 0.02);
            }
            for each (var sheep:Agent in seen)
            {
                sheep.color = ORANGE;
            }
            for each (sheep in near)
            {
                turn(sheep, sheep.x - _wolf.x, sheep.y - _wolf.y);
                walk(sheep, 0.05);
            }
            drawSlice(_wolf, 7, 70, ORANGE);
            draw(_agents);
            drawLink(_wolf, nearest, RED);
            say(seen.length + " in front, " + near.length + " near");
        }
    }
}
